// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/localizer.hpp"

#include <algorithm>
#include <cmath>

#include "localize/option_check.hpp"
#include "localize/pose_belief.hpp"
#include "localize/pose_search.hpp"
#include "localize/tracker.hpp"
#include "localize/wall_map.hpp"

namespace straightedge {

using namespace localize;

namespace {

constexpr std::size_t readings_to_check = 60;
constexpr double most_times = 10;  // that a step without odometry may take, measured by the one before

}  // namespace

struct Localizer::State {
  State(const LocalizeOptions& wanted, const WallMap& walls, const ScanLineFinder& lines)
      : motion_options(wanted.motion),
        map(walls),
        faces(map),
        tolerance_m(wanted.loss.on_wall_m + wanted.loss.on_wall_roughness * map.roughness_m()),
        finder(lines),
        tracker(wanted),
        search(wanted) {}

  bool take_time(const LaserScan& scan);
  std::optional<Pose2> motion_to(const std::optional<Pose2>& odometry);
  void take_lines(const LaserScan& scan);
  void track(const std::optional<Pose2>& motion);
  void look(const std::optional<Pose2>& motion);
  void report(const PoseBelief& belief);

  MotionOptions motion_options;
  WallMap map;
  WallFaces faces;
  double tolerance_m = 0;
  ScanLineFinder finder;
  Tracker tracker;
  PoseSearch search;
  Readings readings;
  LocalizeResult result;
  std::optional<Pose2> last_odometry;
  std::optional<double> last_time;
  double last_step_s = 0, times = 1;
};

/// False: the scan is to be passed over.
bool Localizer::State::take_time(const LaserScan& scan) {
  if (!std::isfinite(scan.time_s)) {
    result.scan = ScanVerdict::unusable;
    return false;
  }
  if (last_time && scan.time_s < *last_time) {
    result.scan = ScanVerdict::time_backwards;
    return false;
  }
  const double took = last_time ? scan.time_s - *last_time : 0;
  times = took > 0 && last_step_s > 0 ? std::min(most_times, took / last_step_s) : 1;
  last_step_s = took;
  last_time = scan.time_s;
  result.time_s = scan.time_s;
  return true;
}

std::optional<Pose2> Localizer::State::motion_to(const std::optional<Pose2>& odometry) {
  std::optional<Pose2> motion;
  if (odometry && usable(*odometry)) {
    if (last_odometry) motion = motion_between(*last_odometry, *odometry);
    last_odometry = odometry;
  } else {
    last_odometry.reset();
  }
  return motion;
}

/// Step 1.
void Localizer::State::take_lines(const LaserScan& scan) {
  if (!finder.run(scan)) {
    result.scan = ScanVerdict::unusable;
  } else {
    result.lines = finder.lines();
    result.line_counts = finder.counts();
    if (finder.points().empty()) result.scan = ScanVerdict::no_readings;
  }
  choose_readings(finder.points(), scan.laser_in_robot, readings_to_check, readings);
}

/// Steps 2 to 5.
void Localizer::State::track(const std::optional<Pose2>& motion) {
  tracker.predict(motion, times);
  if (result.scan == ScanVerdict::used) tracker.correct(map, readings, tolerance_m, result);
  if (tracker.lost()) {
    result.state = LocalizeState::lost;
    search.start();
  }
  report(tracker.belief());
}

/// Step 6.
void Localizer::State::look(const std::optional<Pose2>& motion) {
  result.matches.assign(result.lines.size(), LineMatch{});
  const auto found =
      search.step({map, faces, tolerance_m, result.lines, readings, motion}, result.search_counts);
  if (found) {
    result.state = LocalizeState::tracking;
    tracker.start(*found);
    tracker.explain(map, result);
  }
  if (search.hypotheses().empty()) return;
  result.fit = search.hypotheses().front().fit;
  report(search.hypotheses().front().belief);
}

void Localizer::State::report(const PoseBelief& belief) {
  result.pose = belief.pose;
  result.covariance = pose_covariance(belief).v;
  result.has_pose = result.state == LocalizeState::tracking;
}

/// Sums up what became of the lines.
static MatchCounts count_verdicts(const std::vector<LineMatch>& matches) {
  MatchCounts counts;
  counts.lines = static_cast<std::uint32_t>(matches.size());
  for (const LineMatch& match : matches) {
    std::uint32_t* const of[] = {&counts.matched, &counts.no_wall,   &counts.wrong_side, &counts.no_overlap,
                                 &counts.gate,    &counts.not_joint, &counts.ambiguous,  &counts.no_pose};
    ++*of[static_cast<std::size_t>(match.verdict)];
  }
  return counts;
}

Localizer::Localizer(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;
Localizer::Localizer(const Localizer& other) : state_(std::make_unique<State>(*other.state_)) {}
Localizer& Localizer::operator=(const Localizer& other) {
  return *this = Localizer(other);
}
Localizer::~Localizer() = default;

Result<Localizer> Localizer::create(const LineMap& map, const LocalizeOptions& options) {
  if (const char* objection = localize::objection_to(options)) return Failure{Problem::bad_option, objection};
  if (const char* objection = localize::objection_to(map)) return Failure{Problem::bad_content, objection};
  auto finder = ScanLineFinder::create(options.lines);
  if (!finder) return finder.failure();
  Localizer localizer(std::make_unique<State>(options, WallMap(map, options.match), *finder));
  if (options.start) localizer.start_at(*options.start, options.start_covariance);
  return localizer;
}

const LocalizeResult& Localizer::step(const LaserScan& scan, const std::optional<Pose2>& odometry) {
  State& state = *state_;
  LocalizeResult& result = state.result;
  result.scan = ScanVerdict::used;
  result.line_counts = {};
  result.match_counts = {};
  result.search_counts = {};
  result.fit = {};
  result.mean_chi_square = 0;
  result.lines.clear();
  result.matches.clear();
  if (!state.take_time(scan)) return result;
  const auto motion = state.motion_to(odometry);
  state.take_lines(scan);
  if (result.state == LocalizeState::tracking) {
    state.track(motion);
  } else {
    state.look(motion);
  }
  result.match_counts = count_verdicts(result.matches);
  return result;
}

const LocalizeResult& Localizer::result() const noexcept {
  return state_->result;
}

void Localizer::start_at(const Pose2& pose, const std::array<double, 9>& covariance) {
  const PoseBelief belief = belief_at(pose, {covariance}, state_->motion_options);
  state_->tracker.start(belief);
  state_->result.state = LocalizeState::tracking;
  state_->report(belief);
}

}  // namespace straightedge
