// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "map/edge_points.hpp"
#include "map/wall_line.hpp"
#include "straightedge/hough_lines.hpp"

namespace straightedge {

/// From rough segments, many of them of one and the same edge, to straight edges that share no pixel.
///
/// 1. The rough segments with most pixels come first.
/// 2. Refit one after the other on the pixels that are still free. If enough are left to carry it, it is an
///    edge, and its pixels are taken.
/// So a duplicate finds nothing to stand on. `points` keep the pixels that nobody took.
std::vector<WallLine> select_edges(std::span<const HoughSegment> rough, const RefitOptions& options,
                                   double min_length, EdgePoints& points);

}  // namespace straightedge
