// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/select.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "hough/refit_recipe.hpp"

namespace straightedge {
namespace {

// Edge pixels a pixel of length: a diagonal has 0.7, a ragged wall fewer.
constexpr double min_density = 0.45;
// Pixels beside the line that belong to the same edge: its staircase.
constexpr double claim_corridor = 2.2;
constexpr double claim_angle = 0.7;
constexpr double claim_margin = 1.5;

bool carries(const RefinedSegment& segment, double min_length) {
  return segment.pixels > 2 && segment.length() >= min_length &&
         segment.pixels >= min_density * segment.length();
}

}  // namespace

std::vector<WallLine> select_edges(std::span<const HoughSegment> rough, const RefitOptions& options,
                                   double min_length, EdgePoints& points) {
  // Step 1.
  std::vector<std::size_t> order(rough.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rough[a].pixels > rough[b].pixels; });
  std::vector<WallLine> edges;
  for (const std::size_t i : order) {  // Step 2
    RefinedSegment segment;
    if (refitting::refit(points, rough[i], options, segment) != Status::ok) continue;
    if (!carries(segment, min_length)) continue;
    refitting::claim(points, segment, claim_corridor, claim_angle, claim_margin);
    edges.push_back(wall_line_from(segment, static_cast<std::uint32_t>(std::max(rough[i].votes, 0))));
  }
  return edges;
}

}  // namespace straightedge
