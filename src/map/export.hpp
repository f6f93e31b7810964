// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "map/picture.hpp"
#include "map/wall_line.hpp"
#include "straightedge/host/line_map.hpp"

namespace straightedge {

/// From columns and rows to the map's frame: origin at the image's centre, y up; rho, theta and the order
/// of ends in normal form; its floor (line_floor.hpp) added to each line's covariance. `groups` are the
/// segments of each line.
std::vector<MapLine> to_map_lines(const std::vector<WallLine>& lines,
                                  const std::vector<std::vector<std::size_t>>& groups,
                                  const PictureFacts& picture, Size image);

}  // namespace straightedge
