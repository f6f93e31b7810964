// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

constexpr std::size_t most_readings = 4'000'000;  // of a drawing
constexpr std::size_t most_search_scans = 4;      // that are shown before a pose is found

using Clock = std::chrono::steady_clock;

void add(MatchCounts& sum, const MatchCounts& one) {
  sum.lines += one.lines;
  sum.matched += one.matched;
  sum.no_wall += one.no_wall;
  sum.wrong_side += one.wrong_side;
  sum.no_overlap += one.no_overlap;
  sum.gate += one.gate;
  sum.not_joint += one.not_joint;
  sum.ambiguous += one.ambiguous;
  sum.no_pose += one.no_pose;
}

std::size_t beams_of(const LaserLog& log) {
  std::size_t beams = 0;
  for (const LoggedScan& logged : log.scans) beams += logged.scan.ranges_m.size();
  return beams;
}

/// Goes through the log and keeps the books.
class Follower {
 public:
  Follower(const LaserLog& log, const LocalizeRunOptions& options)
      : log_(log), options_(options), wanted_(options.explain_scan.has_value()) {
    run_.beams = beams_of(log);
    thinning_ = run_.beams / most_readings + 1;
    if (options.localize.start) before_ = options.localize.start;
  }

  void note(std::size_t scan, const LocalizeResult& result, double milliseconds) {
    const LoggedScan& logged = log_.scans[scan];
    run_.milliseconds.push_back(milliseconds);
    run_.lines += result.lines.size();
    if (logged.odometry) ++run_.with_odometry;
    if (result.scan == ScanVerdict::no_readings) ++run_.without_reading;
    if (result.has_pose != had_pose_) {
      run_.events.push_back({result.has_pose, scan});
      if (!result.has_pose) ++run_.lost_times;
    }
    if (wanted_) {
      latest_ = {scan, result, expected_at(scan)};
      explain(scan, result);
    }
    if (result.has_pose) note_pose(scan, result);
    had_pose_ = result.has_pose;
    before_ = result.has_pose ? std::optional(result.pose) : std::nullopt;
    odometry_before_ = logged.odometry;
  }

  LocalizeRun take() {
    // A scan such as the one that was asked for never came.
    if (wanted_ && run_.explained.empty()) run_.explained.push_back(std::move(latest_));
    return std::move(run_);
  }

 private:
  void note_pose(std::size_t scan, const LocalizeResult& result) {
    const LaserScan& of = log_.scans[scan].scan;
    add(run_.matches, result.match_counts);
    run_.poses.push_back({of.time_s, result.pose, result.covariance});
    run_.scan_of.push_back(scan);
    if (!options_.readings || scan % thinning_ != 0) return;
    const std::vector<Point2> points = points_of(of, result.pose);
    run_.readings.insert(run_.readings.end(), points.begin(), points.end());
  }

  void explain(std::size_t scan, const LocalizeResult& result) {
    const std::size_t number = *options_.explain_scan;
    const bool this_one =
        number == 0 ? latest_.expected && result.match_counts.matched > 0 : scan + 1 == number;
    if (!this_one && had_pose_) {
      run_.explained.clear();  // an earlier search
      return;
    }
    if (!this_one && run_.explained.size() == most_search_scans) run_.explained.pop_back();
    run_.explained.push_back(latest_);
    wanted_ = !this_one;
  }

  std::optional<Pose2> expected_at(std::size_t scan) const {
    const auto& odometry = log_.scans[scan].odometry;
    if (!before_) return {};
    if (!odometry || !odometry_before_) return before_;
    return compose(*before_, motion_between(*odometry_before_, *odometry));
  }

  const LaserLog& log_;
  const LocalizeRunOptions& options_;
  LocalizeRun run_;
  std::size_t thinning_ = 1;
  bool wanted_ = false;
  ExplainedScan latest_;
  bool had_pose_ = false;
  std::optional<Pose2> before_, odometry_before_;
};

}  // namespace

std::vector<Point2> points_of(const LaserScan& scan, const Pose2& world_from_robot) {
  const Pose2 world_from_laser = compose(world_from_robot, scan.laser_in_robot);
  std::vector<Point2> points;
  points.reserve(scan.ranges_m.size());
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range = static_cast<double>(scan.ranges_m[i]);
    if (!(range > 0) || !std::isfinite(range) || (scan.max_range_m > 0 && range >= scan.max_range_m))
      continue;
    const double angle =
        world_from_laser.heading_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
    const SineCosine turn = sine_cosine(angle);
    points.push_back({world_from_laser.x_m + range * turn.cosine, world_from_laser.y_m + range * turn.sine});
  }
  return points;
}

Result<LocalizeRun> run_localize(const LineMap& map, const LaserLog& log, const LocalizeRunOptions& options,
                                 Progress& progress) {
  auto localizer = Localizer::create(map, options.localize);
  if (!localizer) return localizer.failure();
  Follower follower(log, options);
  const std::string of_all = " of " + io::to_text(log.scans.size());
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    if (i % 64 == 0) progress.tell("scan " + io::to_text(i + 1) + of_all);
    const Clock::time_point begin = Clock::now();
    const LocalizeResult& result = localizer->step(log.scans[i].scan, log.scans[i].odometry);
    const std::chrono::duration<double, std::milli> taken = Clock::now() - begin;
    follower.note(i, result, taken.count());
  }
  return follower.take();
}

}  // namespace straightedge::cli
