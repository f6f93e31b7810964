// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "budget/case.hpp"
#include "straightedge/points_view.hpp"

namespace firmware {

/// One pixel in sixteen of the room of scenes/room.hpp, in metres.
straightedge::PointsView room_points(straightedge::Size size) noexcept;

constexpr std::uint32_t points_of(straightedge::Size size) noexcept {
  return static_cast<std::uint32_t>(pixels_of(size) / 16);
}
inline constexpr std::uint32_t most_points = most_pixels / 16;

}  // namespace firmware
