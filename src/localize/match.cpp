// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/match.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge::localize {
namespace {

/// Whether it matters which of two walls a line is: they would put the robot to different places.
bool differ(const LinePair& a, const LinePair& b, const WallMap& map) {
  if (a.wall == b.wall) return false;
  const Wall &wall_a = map.walls()[a.wall], &wall_b = map.walls()[b.wall];
  const double sigma = std::sqrt(a.var_offset + wall_a.var_offset + wall_b.var_offset);
  const double turn = std::sqrt(a.var_theta + wall_a.var_theta + wall_b.var_theta);
  // The offsets are told along normals that may point to opposite sides.
  const double side = wall_a.nx * wall_b.nx + wall_a.ny * wall_b.ny < 0 ? -1 : 1;
  return std::fabs(a.offset - side * b.offset) > 2 * sigma || std::fabs(a.angle - b.angle) > 2 * turn;
}

}  // namespace

void Matcher::choose_nearest(const WallMap& map, std::span<const ScanLine> lines, const MatchOptions& options,
                             const PoseBelief& belief) {
  best_.pair.assign(lines.size(), no_pair);
  rivals_.clear();
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < lines.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return lines[a].var_theta < lines[b].var_theta; });
  PoseBelief trial = belief;
  for (const std::uint32_t i : order) {
    double nearest = options.gate;
    LinePair chosen;
    for (std::uint32_t p = list_.starts[i]; p < list_.starts[i + 1]; ++p) {
      LinePair pair = make_pair(trial.pose, lines[i], i, map, list_.pairs[p].wall);
      if (!judge_pair(pair, trial, map.walls()[pair.wall]) || pair.chi_square > nearest) continue;
      nearest = pair.chi_square;
      chosen = pair;
      best_.pair[i] = p;
    }
    if (best_.pair[i] != no_pair) correct(trial, chosen, map);
  }
}

void Matcher::refuse_ambiguous(const WallMap& map, std::vector<LineMatch>& matches) {
  const auto matched =
      std::count_if(best_.pair.begin(), best_.pair.end(), [](std::uint32_t p) { return p != no_pair; });
  for (std::uint32_t i = 0; i < best_.pair.size(); ++i) {
    if (best_.pair[i] == no_pair) continue;
    const LinePair& chosen = list_.pairs[best_.pair[i]];
    bool doubtful = false;
    for (const Assignment& rival : rivals_) {
      doubtful |= rival.pair[i] != no_pair && differ(chosen, list_.pairs[rival.pair[i]], map);
    }
    // A lone wall has no witness: any other wall within its gate is a rival.
    for (std::uint32_t p = list_.starts[i]; matched == 1 && p < list_.starts[i + 1]; ++p) {
      doubtful |= differ(chosen, list_.pairs[p], map);
    }
    if (!doubtful) continue;
    best_.pair[i] = no_pair;
    matches[i].verdict = LineVerdict::ambiguous;
  }
}

double Matcher::match_and_correct(const WallMap& map, std::span<const ScanLine> lines,
                                  const MatchOptions& options, PoseBelief& belief,
                                  std::vector<LineMatch>& matches) {
  find_pairs(map, belief, lines, options, list_, matches);
  if (options.association == Association::nearest) {
    choose_nearest(map, lines, options, belief);
  } else {
    joint_hypotheses(map, belief, list_, options, best_, rivals_);
  }
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const bool had_pairs = list_.starts[i] < list_.starts[i + 1];
    if (had_pairs && best_.pair[i] == no_pair) matches[i].verdict = LineVerdict::not_joint;
  }
  refuse_ambiguous(map, matches);
  double chi_squares = 0;
  int pairs = 0;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (best_.pair[i] == no_pair) continue;
    const LinePair& chosen = list_.pairs[best_.pair[i]];
    const Wall& wall = map.walls()[chosen.wall];
    matches[i] = {LineVerdict::matched, wall.line_id, wall.segment_id, true, chosen.chi_square};
    chi_squares += chosen.chi_square;
    ++pairs;
    LinePair pair = make_pair(belief.pose, lines[i], i, map, chosen.wall);
    if (judge_pair(pair, belief, wall)) correct(belief, pair, map);
  }
  forget_far_lines(belief, [&](std::uint32_t line) { return map.variances(line); });
  return pairs > 0 ? chi_squares / pairs : 0;
}

}  // namespace straightedge::localize
