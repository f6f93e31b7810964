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
constexpr double slip_share = 0.85;  // of the usual share of readings on walls; below it, a slip is tried
constexpr double slip_gain = 1.5;    // log likelihood that a slip must bring
constexpr double slip_m = 0.3;
constexpr double slip_rad = 0.1;
constexpr double most_step_ratio = 10;
constexpr double usual_gain = 0.05;  // of the running mean

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
        last_step_s(other.last_step_s),
        step_ratio(other.step_ratio),
        doubts(other.doubts),
        usual_on_walls(other.usual_on_walls) {
    search.moved_to(map, faces);
  }

  double tolerance() const {
    return options.loss.on_wall_m + options.loss.on_wall_roughness * map.roughness_m();
  }

  bool take_time(const LaserScan& scan);
  std::optional<Pose2> motion_to(const std::optional<Pose2>& odometry);
  void track(const std::optional<Pose2>& motion);
  void try_slip(const PoseBelief& predicted, PoseScore& score);
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
  double last_step_s = 0, step_ratio = 1;
  std::uint32_t doubts = 0;
  double usual_on_walls = 0.8;
  std::vector<LineMatch> slip_matches;
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
  step_ratio = took > 0 && last_step_s > 0 ? std::min(most_step_ratio, took / last_step_s) : 1;
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

void Localizer::State::track(const std::optional<Pose2>& motion) {
  // Step 2.
  if (motion) {
    predict(belief, *motion, options.motion);
  } else {
    predict_blindly(belief, last_motion, step_ratio, options.motion);
  }
  if (result.scan != ScanVerdict::used) return;
  // Steps 3 and 4.
  const PoseBelief predicted = belief;
  result.mean_chi_square =
      matcher.match_and_correct(map, result.lines, options.match, belief, result.matches);
  // Step 5.
  PoseScore score = score_pose(map, belief.pose, readings, tolerance());
  if (score.fit.on_walls < slip_share * usual_on_walls) try_slip(predicted, score);
  result.fit = score.fit;
  check();
}

/// The scan lies worse than those before: perhaps the odometry was late, or the robot has slipped or was
/// pushed. The same scan once more, with a wider prediction; kept if the readings say that it is much better.
void Localizer::State::try_slip(const PoseBelief& predicted, PoseScore& score) {
  PoseBelief wide = predicted;
  wide.covariance(0, 0) += slip_m * slip_m;
  wide.covariance(1, 1) += slip_m * slip_m;
  wide.covariance(2, 2) += slip_rad * slip_rad;
  const double chi_square = matcher.match_and_correct(map, result.lines, options.match, wide, slip_matches);
  const PoseScore slipped = score_pose(map, wide.pose, readings, tolerance());
  if (slipped.log_likelihood < score.log_likelihood + slip_gain) return;
  score = slipped;
  belief = std::move(wide);
  result.matches = slip_matches;
  result.mean_chi_square = chi_square;
}

void Localizer::State::check() {
  const LossOptions& loss = options.loss;
  const ScanFit& fit = result.fit;
  const auto matched = static_cast<double>(
      std::count_if(result.matches.begin(), result.matches.end(),
                    [](const LineMatch& match) { return match.verdict == LineVerdict::matched; }));
  // Fewer walls than usual may be the map's fault; then the lines that there are still match.
  const bool worse = fit.on_walls < loss.usual_share * usual_on_walls;
  const bool unmatched = matched < loss.min_matched * static_cast<double>(result.matches.size());
  const bool against = fit.on_walls < loss.min_on_walls || fit.through_walls > loss.max_through_walls ||
                       (worse && (unmatched || fit.through_walls > 0.5 * loss.max_through_walls));
  if (!against) usual_on_walls += usual_gain * (fit.on_walls - usual_on_walls);
  doubts = against ? doubts + 1 : doubts - std::min(doubts, 1U);
  const double vague = belief.covariance(0, 0) + belief.covariance(1, 1);
  const bool gone = !usable(belief.pose) || !(vague <= loss.max_sigma_m * loss.max_sigma_m);
  if (doubts >= loss.scans || gone) lose();
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
  result.covariance = pose_covariance(belief).v;
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
  state_->belief = belief_at(pose, {covariance}, state_->options.motion);
  state_->last_pose = pose;
  state_->last_motion = {};
  state_->doubts = 0;
  state_->result.state = LocalizeState::tracking;
  state_->report();
}

}  // namespace straightedge
