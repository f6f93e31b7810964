// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/wall_line.hpp"

namespace straightedge {

/// Moves the ends of segments that all but meet onto the point where their lines cross: the corners of a
/// room. An end moves by at most `reach` pixels along its own line, and only to a line that comes as near
/// to the crossing itself, at an angle of 20 degrees or more. The nearest crossing counts.
/// At a slight bend, 6 to 20 degrees, two pieces that continue one another overlap: both end at the crossing.
/// `helpers` are lines too short for the map that corners may still lie on.
void close_corners(std::vector<WallLine>& lines, const std::vector<WallLine>& helpers, double reach);

}  // namespace straightedge
