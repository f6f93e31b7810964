// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/line_sampler.hpp"
#include "map/wall_line.hpp"

namespace straightedge {

/// Joins the two edges of each thin wall into its axis.
///
/// 1. Two edges are the sides of one wall when their light sides point away from each other, dark lies
///    between them, they are near and nearly parallel, and they run beside one another.
/// 2. The wall's width is the darkness across it: the sum of (ground − gray) over the depth of black. Blur
///    moves the two edges apart but leaves this sum as it is.
/// 3. Thin enough: each side is moved half the distance inwards and both are fitted as one line, the axis.
///    Longer edges come first and take all the edges that lie opposite to them.
/// Thick walls keep their two faces. `picture` is the stretched one (black = wall, white = ground).
/// Returns how many axes were made.
std::uint32_t join_thin_walls(std::vector<WallLine>& lines, const LineSampler& picture, double max_width);

}  // namespace straightedge
