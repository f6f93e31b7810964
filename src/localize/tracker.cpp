// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/tracker.hpp"

#include <algorithm>
#include <utility>

namespace straightedge::localize {
namespace {

constexpr double first_usual = 0.8;  // share of readings on walls, before there is a mean of it
constexpr double usual_gain = 0.05;  // of the running mean
constexpr double slip_share = 0.85;  // of the usual share; below it, a slip is tried
constexpr double slip_gain = 1.5;    // log likelihood that a slip must bring
constexpr double slip_m = 0.3;
constexpr double slip_rad = 0.1;

}  // namespace

void Tracker::start(const PoseBelief& belief) {
  belief_ = belief;
  last_pose_ = belief.pose;
  last_motion_ = {};
  doubts_ = 0;
  usual_on_walls_ = first_usual;
}

void Tracker::explain(const WallMap& map, LocalizeResult& result) {
  PoseBelief corrected_again = belief_;
  result.mean_chi_square =
      matcher_.match_and_correct(map, result.lines, options_.match, corrected_again, result.matches);
}

void Tracker::predict(const std::optional<Pose2>& motion, double times) {
  last_motion_ = motion_between(last_pose_, belief_.pose);
  last_pose_ = belief_.pose;
  if (motion) {
    localize::predict(belief_, *motion, options_.motion);
  } else {
    predict_blindly(belief_, last_motion_, times, options_.motion);
  }
}

/// The scan lies worse than those before: perhaps the odometry was late, or the robot has slipped or was
/// pushed. The same scan once more, with a wider prediction; kept if the readings say that it is much better.
void Tracker::try_slip(const WallMap& map, const Readings& readings, double tolerance_m, PoseScore& score,
                       LocalizeResult& result) {
  PoseBelief& wide = predicted_;
  wide.covariance(0, 0) += slip_m * slip_m;
  wide.covariance(1, 1) += slip_m * slip_m;
  wide.covariance(2, 2) += slip_rad * slip_rad;
  const double chi_square =
      matcher_.match_and_correct(map, result.lines, options_.match, wide, slip_matches_);
  const PoseScore slipped = score_pose(map, wide.pose, readings, tolerance_m);
  if (slipped.log_likelihood < score.log_likelihood + slip_gain) return;
  score = slipped;
  std::swap(belief_, wide);
  std::swap(result.matches, slip_matches_);
  result.mean_chi_square = chi_square;
}

bool Tracker::speaks_against(const LocalizeResult& result) const {
  const LossOptions& loss = options_.loss;
  const ScanFit& fit = result.fit;
  if (fit.on_walls < loss.min_on_walls || fit.through_walls > loss.max_through_walls) return true;
  // Fewer readings on walls than usual may be the map's fault; then the lines that there are still match, and
  // no beam goes through a wall.
  if (fit.on_walls >= loss.usual_share * usual_on_walls_) return false;
  const auto matched = static_cast<double>(
      std::count_if(result.matches.begin(), result.matches.end(),
                    [](const LineMatch& match) { return match.verdict == LineVerdict::matched; }));
  return matched < loss.min_matched * static_cast<double>(result.matches.size()) ||
         fit.through_walls > 0.5 * loss.max_through_walls;
}

void Tracker::correct(const WallMap& map, const Readings& readings, double tolerance_m,
                      LocalizeResult& result) {
  // Steps 3 and 4.
  predicted_ = belief_;
  result.mean_chi_square =
      matcher_.match_and_correct(map, result.lines, options_.match, belief_, result.matches);
  // Step 5.
  PoseScore score = score_pose(map, belief_.pose, readings, tolerance_m);
  if (score.fit.on_walls < slip_share * usual_on_walls_) try_slip(map, readings, tolerance_m, score, result);
  result.fit = score.fit;
  if (speaks_against(result)) {
    ++doubts_;
  } else {
    doubts_ -= std::min(doubts_, 1U);
    usual_on_walls_ += usual_gain * (score.fit.on_walls - usual_on_walls_);
  }
}

bool Tracker::lost() const {
  const double limit = options_.loss.max_sigma_m;
  const double vague = belief_.covariance(0, 0) + belief_.covariance(1, 1);
  return doubts_ >= options_.loss.scans || !usable(belief_.pose) || !(vague <= limit * limit);
}

}  // namespace straightedge::localize
