// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localize/match.hpp"
#include "localize/pose_belief.hpp"
#include "localize/scan_fit.hpp"

namespace straightedge::localize {

/// Follows a robot whose place is known: steps 2 to 5 of localizer.hpp.
class Tracker {
 public:
  explicit Tracker(const LocalizeOptions& options) : options_(options) {}

  void start(const PoseBelief& belief);

  /// What the lines of `result` are in the map, where the belief has been corrected by them already.
  void explain(const WallMap& map, LocalizeResult& result);

  /// Step 2. `times`: how many times as long as the step before this one took; for robots without odometry.
  void predict(const std::optional<Pose2>& motion, double times);

  /// Steps 3 to 5 with the lines of `result`, which gets what became of them.
  void correct(const WallMap& map, const Readings& readings, double tolerance_m, LocalizeResult& result);

  /// The scans have spoken against the pose for too long, or nobody knows where it is any more.
  bool lost() const;

  const PoseBelief& belief() const { return belief_; }

 private:
  void try_slip(const WallMap& map, const Readings& readings, double tolerance_m, PoseScore& score,
                LocalizeResult& result);
  bool speaks_against(const LocalizeResult& result) const;

  LocalizeOptions options_;
  PoseBelief belief_, predicted_;
  Matcher matcher_;
  std::vector<LineMatch> slip_matches_;
  Pose2 last_pose_, last_motion_;
  std::uint32_t doubts_ = 0;
  double usual_on_walls_ = 0;
};

}  // namespace straightedge::localize
