// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/depth_view.hpp"
#include "straightedge/gray.hpp"
#include "straightedge/image.hpp"
#include "straightedge/points_view.hpp"

/// What all cases look at, made in integers from chance with a fixed seed. Sizes are odd, rows do not follow
/// one another without gaps.
namespace same_bits {

inline constexpr straightedge::Size picture_size{157, 121};
inline constexpr straightedge::Size color_size{61, 37};
inline constexpr straightedge::Size depth_size{131, 97};
inline constexpr std::uint32_t room_points = 1500;
inline constexpr std::uint32_t seen_points = 44 * 33;

/// Before anything else below.
void make_inputs() noexcept;

/// Boxes and slanted bars on an uneven ground, with noise.
straightedge::GrayView picture() noexcept;
/// Black and white by chance: of picture_size.
straightedge::GrayView noise_picture() noexcept;
/// One gray value: of picture_size.
straightedge::GrayView blank_picture() noexcept;
/// Chance, read as this format.
straightedge::ColorView color_picture(straightedge::PixelFormat format) noexcept;

/// The corner of a room with a box and a ball before it, with noise, steps and holes.
straightedge::DepthView depth_picture() noexcept;
/// The same camera without a reading.
straightedge::DepthView blank_depth() noexcept;

/// Points on three planes and beside them, a few that are not finite.
straightedge::PointsView room_cloud() noexcept;
/// Every third pixel of the depth picture as a point, in rows; holes are not finite.
straightedge::PointsView seen_cloud() noexcept;

}  // namespace same_bits
