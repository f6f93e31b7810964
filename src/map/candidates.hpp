// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/edge_points.hpp"
#include "map/hough_room.hpp"
#include "map/wall_line.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace straightedge {

/// What finding edges needs, kept from one picture to the next.
struct EdgeRoom {
  EdgePoints points;
  HoughRoom hough;
};

/// From edge pixels to straight edges: rounds of the Hough transform, each on the pixels that the one before
/// left, with lower demands after the first. Every segment is refit between the pixels and takes its own.
/// Without a magnitude of positions: that of their gradient, by the norm of the options. The report gets the
/// counts. Statuses are those of HoughLines.
Status find_edges(GrayView edges, const EdgeSources& sources, const LineMapOptions& options,
                  const KernelSet& kernels, EdgeRoom& room, std::vector<WallLine>& lines,
                  LineMapReport& report);

}  // namespace straightedge
