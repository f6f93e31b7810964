// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "map/wall_line.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge {

/// Leaves out the faces of things that stand alone and are small: boxes, pillars, furniture. They are no
/// walls, and the next day they stand elsewhere.
///
/// 1. Connected dark areas of the stretched picture (8-neighbours, darker than the half).
/// 2. A face goes when the area on its dark side fits into `max_size` pixels in width and height and is
///    thicker than a thin wall. What is no thicker stays, however short: a dashed wall is made of such
///    pieces.
/// Returns how many faces went. `marks` is memory that may be kept from one picture to the next.
std::uint32_t drop_furniture(std::vector<WallLine>& lines, GrayView picture, double max_size,
                             double max_wall_width, Image<std::uint8_t>& marks);

}  // namespace straightedge
