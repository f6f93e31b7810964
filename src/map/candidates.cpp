// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/candidates.hpp"

#include <algorithm>

#include "map/select.hpp"
#include "straightedge/hough_grid.hpp"

namespace straightedge {
namespace {

constexpr int max_rounds = 3;
constexpr double shortest_edge = 6;  // pixels; corners and thin walls need the short ones, too

/// What the next round asks for: less, for the long edges are gone.
HoughOptions relaxed(HoughOptions options) {
  options.threshold = std::max(options.threshold * 2 / 3, 1);
  options.min_length *= 0.7;
  return options;
}

}  // namespace

Status find_edges(GrayView edges, const EdgeSources& sources, const LineMapOptions& options,
                  const KernelSet& kernels, EdgeRoom& room, std::vector<WallLine>& lines,
                  LineMapReport& report) {
  HoughOptions hough = first_round(options);
  const Status may = hough_grid(edges.size(), hough).status;
  if (may != Status::ok) return may;  // before a picture too large takes memory
  room.points.find(edges, sources, options.canny.norm, kernels);
  hough.kernels = kernels.hough;
  RefitOptions refit;
  refit.max_gap = std::min(options.max_gap, 8.0);
  for (int round = 0; round < max_rounds; ++round) {
    const std::span<const HoughSegment> rough =
        room.hough.run(room.points.mask(), {sources.directions.stored.x, sources.directions.stored.y}, hough);
    if (room.hough.result.status != Status::ok) return room.hough.result.status;
    if (round == 0) report.hough = room.hough.result;
    ++report.rounds;
    if (rough.empty()) break;
    report.candidates += room.hough.result.segments;
    const std::vector<WallLine> found = select_edges(rough, refit, shortest_edge, room.points);
    lines.insert(lines.end(), found.begin(), found.end());
    if (round == 0) hough = relaxed(hough);
  }
  report.edges = static_cast<std::uint32_t>(lines.size());
  return Status::ok;
}

}  // namespace straightedge
