// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "straightedge/depth_view.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/image.hpp"
#include "straightedge/plane.hpp"

/// A depth frame of the corner of a room with a box, as a Kinect would see it, and its planes as truth.
namespace firmware {

/// The field of view of a Kinect.
straightedge::PinholeCamera kinect(straightedge::Size size) noexcept;

/// Millimetres, with noise and steps that grow with the square of the depth, and a few holes.
void draw_room(straightedge::ImageView<std::uint16_t> out) noexcept;

struct RoomScore {
  std::uint32_t planes = 0;  ///< of the room
  std::uint32_t found = 0;   ///< of these, by one found plane within a degree and a centimetre
  std::uint32_t wrong = 0;   ///< found planes that are none of the room's, or one of them again
};
RoomScore score_room(std::span<const straightedge::FoundPlane> planes) noexcept;

}  // namespace firmware
