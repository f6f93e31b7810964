// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "map/wall_line.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/line_fit.hpp"

namespace straightedge {

/// From columns and rows to the map's frame: origin at the image's centre, y up; rho, theta and the order
/// of ends in normal form; the floor added to each line's covariance. `groups` are the segments of each line.
std::vector<MapLine> to_map_lines(const std::vector<WallLine>& lines,
                                  const std::vector<std::vector<std::size_t>>& groups, Size image,
                                  const LineFloor& floor);

}  // namespace straightedge
