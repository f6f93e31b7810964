// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "localize/line_pair.hpp"
#include "straightedge/host/localizer.hpp"

namespace straightedge::localize {

/// Pairs that may be, before any of them is believed; those of one line stand together, the likeliest first.
struct PairList {
  std::vector<LinePair> pairs;
  std::vector<std::uint32_t> starts;  ///< pairs of line i: [starts[i], starts[i + 1])
};

/// Walls that each line may be, alone: near in angle and distance, the floor on the right side, overlapping,
/// within the chi-square gate. At most max_branches a line. `matches` gets, for lines without any, the stage
/// that the best wall reached.
void find_pairs(const WallMap& map, const PoseBelief& belief, std::span<const ScanLine> lines,
                const MatchOptions& options, PairList& list, std::vector<LineMatch>& matches);

inline constexpr std::uint32_t no_pair = 0xFFFFFFFFU;

/// One way to pair the lines: for each its index into PairList::pairs, or no_pair.
struct Assignment {
  std::vector<std::uint32_t> pair;
  double cost = 0;  ///< sum of chi-squares, and a penalty for each line left out
};

/// Chooses among the pairs. Memory is kept from scan to scan.
class Matcher {
 public:
  /// Steps 3 and 4 of localizer.hpp: matches the lines, corrects the belief with what was chosen. `matches`
  /// says what became of each line. Returns the mean chi-square of the pairs; 0 without any.
  double match_and_correct(const WallMap& map, std::span<const ScanLine> lines, const MatchOptions& options,
                           PoseBelief& belief, std::vector<LineMatch>& matches);

 private:
  void choose_nearest(const WallMap& map, std::span<const ScanLine> lines, const MatchOptions& options,
                      const PoseBelief& belief);
  void refuse_ambiguous(const WallMap& map, std::vector<LineMatch>& matches);

  PairList list_;
  Assignment best_;
  std::vector<Assignment> rivals_;
};

/// The joint hypotheses of least cost, by depth-first search with bounds in the tree of J. Neira and J. D.
/// Tardós (2001, doi:10.1109/70.976019). Each pair is judged after a correction by the pairs above it, so
/// that the sum of chi-squares is that of the joint test; a set whose sum exceeds the 99 % quantile is cut.
/// Leaving out a line that has pairs costs a little more than the gate.
///
/// `best` gets the set of least cost; `rivals` the others within options.ambiguity of it, at most 32.
/// max_nodes ends the search early; then the best until there is kept.
void joint_hypotheses(const WallMap& map, const PoseBelief& belief, const PairList& list,
                      const MatchOptions& options, Assignment& best, std::vector<Assignment>& rivals);

}  // namespace straightedge::localize
