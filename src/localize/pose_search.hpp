// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "localize/match.hpp"
#include "localize/pose_belief.hpp"
#include "localize/pose_candidates.hpp"
#include "localize/scan_fit.hpp"
#include "straightedge/host/localizer.hpp"

namespace straightedge::localize {

/// A place where the robot may be, followed by a filter of its own.
struct Hypothesis {
  PoseBelief belief;
  double past = 0;     ///< log likelihood of the scans that count: those with some way between them
  double present = 0;  ///< of the present scan
  ScanFit fit;         ///< of the present scan
  std::uint32_t scans = 0;

  double total() const { return past + present; }
};

/// What one scan brings to the search.
struct SearchInput {
  const WallMap& map;
  const WallFaces& faces;
  double tolerance_m = 0;  ///< of a reading on a wall
  std::span<const ScanLine> lines;
  const Readings& readings;
  std::optional<Pose2> motion;  ///< since the last scan; none: not known
};

/// Step 6 of localizer.hpp, scan after scan until a pose stands:
///
///  1. Move every hypothesis by the odometry; match, correct, score it with the scan.
///  2. New candidates from this scan (pose_candidates.hpp), corrected too, and scored with the scans before
///     it as well, seen from where the odometry says the robot was then.
///  3. Hypotheses at one place are one; the unlikely ones go.
///  4. The best stands when it leads, explains enough of the scan, and has done so for some scans.
///
/// A robot that stands still learns nothing new: scans between which it has not moved count once.
class PoseSearch {
 public:
  explicit PoseSearch(const LocalizeOptions& options) : options_(options) {}

  /// Forgets everything.
  void start();

  /// The belief that stands, if one does.
  std::optional<PoseBelief> step(const SearchInput& input, SearchCounts& counts);

  /// The likeliest first.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }

 private:
  struct Keyframe {
    Readings readings;
    Pose2 to_present;  ///< the motion since
  };

  void move_all(const std::optional<Pose2>& motion);
  void follow(Hypothesis& hypothesis, const SearchInput& input);
  Hypothesis hypothesis_at(const Pose2& pose, const SearchInput& input);
  void add_candidates(const SearchInput& input, SearchCounts& counts);
  double past_of(const Pose2& pose, const SearchInput& input) const;
  void prune();
  void keep_keyframe(const SearchInput& input);
  bool stands() const;

  LocalizeOptions options_;
  std::vector<Hypothesis> hypotheses_;
  std::vector<Keyframe> keyframes_;
  Pose2 since_keyframe_;
  Matcher matcher_;
  std::vector<LineMatch> matches_;
  std::vector<CandidatePose> candidates_;
};

}  // namespace straightedge::localize
