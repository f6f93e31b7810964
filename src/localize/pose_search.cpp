// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/pose_search.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge::localize {
namespace {

constexpr double keyframe_way_m = 0.4;
constexpr double keyframe_turn_rad = 0.3;
constexpr std::size_t most_keyframes = 5;
constexpr double hopeless = 60;        // log likelihood behind the best
constexpr double first_sigma_m = 0.3;  // of a candidate
constexpr double first_sigma_rad = 0.05;
constexpr int polish_rounds = 2;
constexpr double known_slack = 3;  // a candidate so much likelier replaces the hypothesis at its place
constexpr double loose = 2;        // tolerance for scans before, whose place the odometry tells

bool far(const Pose2& motion) {
  return motion.x_m * motion.x_m + motion.y_m * motion.y_m > keyframe_way_m * keyframe_way_m ||
         std::fabs(wrap_angle(motion.heading_rad)) > keyframe_turn_rad;
}

Matrix3 first_covariance() {
  constexpr double way = first_sigma_m * first_sigma_m, turn = first_sigma_rad * first_sigma_rad;
  return {{way, 0, 0, 0, way, 0, 0, 0, turn}};
}

}  // namespace

void PoseSearch::start() {
  hypotheses_.clear();
  keyframes_.clear();
  since_keyframe_ = {};
}

void PoseSearch::move_all(const std::optional<Pose2>& motion) {
  for (Hypothesis& hypothesis : hypotheses_) {
    if (motion) {
      predict(hypothesis.belief, *motion, options_.motion);
    } else {
      predict_blindly(hypothesis.belief, Pose2{}, 1, options_.motion);
    }
  }
  if (!motion) {  // where the robot was before can not be told any more
    keyframes_.clear();
    return;
  }
  since_keyframe_ = compose(since_keyframe_, *motion);
  for (Keyframe& keyframe : keyframes_) keyframe.to_present = compose(keyframe.to_present, *motion);
}

/// Step 1.
void PoseSearch::follow(Hypothesis& hypothesis, const SearchInput& input) {
  matcher_.match_and_correct(input.map, input.lines, options_.match, hypothesis.belief, matches_);
  const PoseScore score = score_pose(input.map, hypothesis.belief.pose, input.readings, input.tolerance_m);
  hypothesis.present = score.log_likelihood;
  hypothesis.fit = score.fit;
  ++hypothesis.scans;
}

double PoseSearch::past_of(const Pose2& pose, const SearchInput& input) const {
  double past = 0;
  for (const Keyframe& keyframe : keyframes_) {
    const Pose2 then = compose(pose, inverse(keyframe.to_present));
    past += score_pose(input.map, then, keyframe.readings, loose * input.tolerance_m).log_likelihood;
  }
  return past;
}

/// A candidate, corrected by the scan that proposed it.
Hypothesis PoseSearch::hypothesis_at(const Pose2& pose, const SearchInput& input) {
  Hypothesis hypothesis;
  hypothesis.belief.pose = pose;
  for (int round = 0; round < polish_rounds; ++round) {
    hypothesis.belief = belief_at(hypothesis.belief.pose, first_covariance(), options_.motion);
    follow(hypothesis, input);
  }
  hypothesis.scans = 1;
  return hypothesis;
}

/// Step 2.
void PoseSearch::add_candidates(const SearchInput& input, SearchCounts& counts) {
  find_candidates(input.map, input.faces, input.lines, input.readings, loose * input.tolerance_m,
                  options_.search, candidates_, counts);
  // What the scans before the kept ones said is not known of a new pose: it is taken as said of the best.
  const auto best =
      std::max_element(hypotheses_.begin(), hypotheses_.end(),
                       [](const Hypothesis& a, const Hypothesis& b) { return a.total() < b.total(); });
  const double before = best == hypotheses_.end() ? 0 : best->past - past_of(best->belief.pose, input);
  const std::size_t followed = hypotheses_.size();
  for (const CandidatePose& candidate : candidates_) {
    const auto end = hypotheses_.begin() + static_cast<std::ptrdiff_t>(followed);
    const bool known = std::any_of(hypotheses_.begin(), end, [&](const Hypothesis& hypothesis) {
      return same_place(hypothesis.belief.pose, candidate.pose) &&
             hypothesis.present >= candidate.log_likelihood - known_slack;
    });
    if (known) continue;
    Hypothesis hypothesis = hypothesis_at(candidate.pose, input);
    hypothesis.past = before + past_of(hypothesis.belief.pose, input);
    hypotheses_.push_back(std::move(hypothesis));
  }
}

/// Step 3.
void PoseSearch::prune() {
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.total() > b.total(); });
  std::vector<Hypothesis> kept;
  for (Hypothesis& hypothesis : hypotheses_) {
    if (kept.size() >= options_.search.max_hypotheses) break;
    if (!kept.empty() && hypothesis.total() < kept.front().total() - hopeless) break;
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const Hypothesis& other) {
      return same_place(hypothesis.belief.pose, other.belief.pose);
    });
    if (same == kept.end()) {
      kept.push_back(std::move(hypothesis));
    } else {
      same->scans = std::max(same->scans, hypothesis.scans);
    }
  }
  hypotheses_ = std::move(kept);
}

void PoseSearch::keep_keyframe(const SearchInput& input) {
  if (!keyframes_.empty() && !far(since_keyframe_)) return;
  if (keyframes_.size() >= most_keyframes) keyframes_.erase(keyframes_.begin());
  keyframes_.push_back({input.readings, Pose2{}});
  since_keyframe_ = {};
  for (Hypothesis& hypothesis : hypotheses_) {
    hypothesis.past += hypothesis.present;
    hypothesis.present = 0;
  }
}

/// Step 4.
bool PoseSearch::stands() const {
  if (hypotheses_.empty()) return false;
  const Hypothesis& best = hypotheses_.front();
  if (best.scans < options_.search.min_scans) return false;
  if (best.fit.on_walls < options_.search.min_on_walls) return false;
  if (best.fit.through_walls > options_.search.max_through_walls) return false;
  return hypotheses_.size() < 2 || best.total() - hypotheses_[1].total() >= options_.search.lead;
}

std::optional<PoseBelief> PoseSearch::step(const SearchInput& input, SearchCounts& counts) {
  move_all(input.motion);
  if (input.readings.ends.empty()) return std::nullopt;
  for (Hypothesis& hypothesis : hypotheses_) follow(hypothesis, input);
  add_candidates(input, counts);
  prune();
  counts.hypotheses = static_cast<std::uint32_t>(hypotheses_.size());
  if (stands()) return hypotheses_.front().belief;
  keep_keyframe(input);
  return std::nullopt;
}

}  // namespace straightedge::localize
