// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/localizer.hpp"

#include <algorithm>
#include <cmath>

#include "localize/match.hpp"
#include "localize/option_check.hpp"
#include "localize/pose_belief.hpp"
#include "localize/pose_search.hpp"
#include "localize/scan_fit.hpp"
#include "localize/wall_map.hpp"

namespace straightedge {

using namespace localize;

namespace {

constexpr std::size_t readings_to_check = 60;
constexpr double widest_map_m = 1e5;

bool map_is_sound(const WallMap& map) {
  return std::all_of(map.walls().begin(), map.walls().end(), [](const Wall& wall) {
    const double numbers[] = {wall.theta, wall.x, wall.y, wall.begin, wall.end};
    const bool fits = std::all_of(std::begin(numbers), std::end(numbers),
                                  [](double v) { return v > -widest_map_m && v < widest_map_m; });
    return fits && wall.var_theta >= 0 && wall.var_theta < 1e6 && wall.var_offset >= 0 &&
           wall.var_offset < 1e12;
  });
}

}  // namespace

struct Localizer::State {
  State(const LocalizeOptions& wanted, const WallMap& walls, const ScanLineFinder& lines)
      : options(wanted), map(walls), faces(map), finder(lines), search(map, faces, options, tolerance()) {}
  State(const State& other)
      : options(other.options),
        map(other.map),
        faces(other.faces),
        finder(other.finder),
        matcher(other.matcher),
        search(other.search),
        belief(other.belief),
        readings(other.readings),
        result(other.result),
        last_odometry(other.last_odometry),
        last_time(other.last_time),
        last_pose(other.last_pose),
        last_motion(other.last_motion),
        doubts(other.doubts) {
    search.moved_to(map, faces);
  }

  double tolerance() const {
    return options.loss.on_wall_m + options.loss.on_wall_roughness * map.roughness_m();
  }

  bool take_time(const LaserScan& scan);
  std::optional<Pose2> motion_to(const std::optional<Pose2>& odometry);
  void track(const std::optional<Pose2>& motion);
  void check();
  void look(const std::optional<Pose2>& motion);
  void lose();
  void report();

  LocalizeOptions options;
  WallMap map;
  WallFaces faces;
  ScanLineFinder finder;
  Matcher matcher;
  PoseSearch search;
  PoseBelief belief;
  Readings readings;
  LocalizeResult result;
  std::optional<Pose2> last_odometry;
  std::optional<double> last_time;
  Pose2 last_pose;  // for the motion without odometry
  Pose2 last_motion;
  std::uint32_t doubts = 0;
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

void Localizer::State::track(const std::optional<Pose2>& motion) {
  // Step 2.
  if (motion) {
    predict(belief, *motion, options.motion);
  } else {
    predict_blindly(belief, last_motion, options.motion);
  }
  if (result.scan != ScanVerdict::used) return;
  // Steps 3 and 4.
  result.mean_chi_square =
      matcher.match_and_correct(map, result.lines, options.match, belief, result.matches);
  // Step 5.
  result.fit = score_pose(map, belief.pose, readings, tolerance()).fit;
  check();
}

void Localizer::State::check() {
  const bool against = result.fit.on_walls < options.loss.min_on_walls ||
                       result.fit.through_walls > options.loss.max_through_walls;
  doubts = against ? doubts + 1 : doubts - std::min(doubts, 1U);
  const double vague = belief.covariance(0, 0) + belief.covariance(1, 1);
  const bool gone = !usable(belief.pose) || !(vague <= options.loss.max_sigma_m * options.loss.max_sigma_m);
  if (doubts >= options.loss.scans || gone) lose();
}

void Localizer::State::lose() {
  result.state = LocalizeState::lost;
  doubts = 0;
  search.start();
}

/// Step 6.
void Localizer::State::look(const std::optional<Pose2>& motion) {
  result.matches.assign(result.lines.size(), LineMatch{});
  const auto found = search.step({result.lines, readings, motion}, result.search_counts);
  if (found) {
    belief = *found;
    result.state = LocalizeState::tracking;
    result.mean_chi_square = 0;
  } else if (!search.hypotheses().empty()) {
    belief = search.hypotheses().front().belief;
  }
  if (!search.hypotheses().empty()) result.fit = search.hypotheses().front().fit;
}

void Localizer::State::report() {
  result.pose = belief.pose;
  result.covariance = belief.covariance.v;
  result.has_pose = result.state == LocalizeState::tracking;
  MatchCounts& counts = result.match_counts;
  counts = {};
  counts.lines = static_cast<std::uint32_t>(result.matches.size());
  for (const LineMatch& match : result.matches) {
    std::uint32_t* const of[] = {&counts.matched, &counts.no_wall,   &counts.wrong_side, &counts.no_overlap,
                                 &counts.gate,    &counts.not_joint, &counts.ambiguous,  &counts.no_pose};
    ++*of[static_cast<std::size_t>(match.verdict)];
  }
  last_motion = motion_between(last_pose, belief.pose);
  last_pose = belief.pose;
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
  if (const char* objection = objection_to(options)) return Failure{Problem::bad_option, objection};
  if (map.unit != MapUnit::metre)
    return Failure{Problem::bad_content,
                   "the map is in pixels; a robot needs it in metres, with a resolution"};
  const bool empty = std::all_of(map.lines.begin(), map.lines.end(),
                                 [](const MapLine& line) { return line.segments.empty(); });
  if (empty) return Failure{Problem::bad_content, "the map has no walls to find a robot by"};
  auto finder = ScanLineFinder::create(options.lines);
  if (!finder) return finder.failure();
  const WallMap walls(map, options.match);
  if (!map_is_sound(walls))
    return Failure{Problem::bad_content, "the map has numbers that are not finite or span more than 100 km"};
  Localizer localizer(std::make_unique<State>(options, walls, *finder));
  if (options.start) localizer.start_at(*options.start, options.start_covariance);
  return localizer;
}

const LocalizeResult& Localizer::step(const LaserScan& scan, const std::optional<Pose2>& odometry) {
  State& state = *state_;
  LocalizeResult& result = state.result;
  result.scan = ScanVerdict::used;
  result.line_counts = {};
  result.search_counts = {};
  result.fit = {};
  result.mean_chi_square = 0;
  result.lines.clear();
  result.matches.clear();
  if (!state.take_time(scan)) return result;
  const auto motion = state.motion_to(odometry);
  // Step 1.
  if (!state.finder.run(scan)) {
    result.scan = ScanVerdict::unusable;
  } else {
    result.lines = state.finder.lines();
    result.line_counts = state.finder.counts();
    if (state.finder.points().empty()) result.scan = ScanVerdict::no_readings;
  }
  choose_readings(state.finder.points(), scan.laser_in_robot, readings_to_check, state.readings);
  if (result.state == LocalizeState::tracking) {
    state.track(motion);
  } else {
    state.look(motion);
  }
  state.report();
  return result;
}

const LocalizeResult& Localizer::result() const noexcept {
  return state_->result;
}

void Localizer::start_at(const Pose2& pose, const std::array<double, 9>& covariance) {
  state_->belief = {pose, {covariance}, {}};
  state_->last_pose = pose;
  state_->last_motion = {};
  state_->doubts = 0;
  state_->result.state = LocalizeState::tracking;
  state_->report();
}

}  // namespace straightedge
