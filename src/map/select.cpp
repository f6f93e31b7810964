// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/select.hpp"

#include <algorithm>
#include <cstddef>

namespace straightedge {
namespace {

// Edge pixels a pixel of length: a diagonal has 0.7, a ragged wall fewer.
constexpr double min_density = 0.45;
// Pixels beside the line that belong to the same edge: its staircase.
constexpr double claim_corridor = 2.2;
constexpr double claim_angle = 0.7;
constexpr double claim_margin = 1.5;

struct Candidate {
  std::size_t index;
  RefinedSegment segment;
};

bool carries(const RefinedSegment& segment, double min_length) {
  return segment.pixels > 2 && segment.length() >= min_length &&
         segment.pixels >= min_density * segment.length();
}

}  // namespace

std::vector<WallLine> select_edges(std::span<const HoughSegment> rough, const GradientField& field,
                                   const RefitOptions& options, double min_length,
                                   ImageView<std::uint8_t> mask) {
  std::vector<Candidate> candidates;
  RefitOptions few_rounds = options;
  few_rounds.rounds = std::min(options.rounds, 2);
  for (std::size_t i = 0; i < rough.size(); ++i) {  // Step 1
    RefinedSegment segment;
    if (refit_segment(mask, field, rough[i], few_rounds, segment) != Status::ok) continue;
    if (carries(segment, min_length)) candidates.push_back({i, segment});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.segment.pixels > b.segment.pixels;
  });
  std::vector<WallLine> edges;
  for (const Candidate& candidate : candidates) {  // Step 2
    const std::int32_t votes = rough[candidate.index].votes;
    RefinedSegment segment = candidate.segment;
    if (refit_again(mask, field, options, segment) != Status::ok) continue;
    if (!carries(segment, min_length)) continue;
    claim_pixels(mask, field, segment, claim_corridor, claim_angle, claim_margin);
    edges.push_back(wall_line_from(segment, static_cast<std::uint32_t>(std::max(votes, 0))));
  }
  return edges;
}

}  // namespace straightedge
