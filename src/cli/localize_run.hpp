// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cli/progress.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/localizer.hpp"
#include "straightedge/host/planar_trajectory.hpp"

namespace straightedge::cli {

/// The robot is found, or lost, at a scan.
struct LocalizeEvent {
  bool found = false;
  std::size_t scan = 0;  ///< index into the log
};

/// A scan that becomes pictures.
struct ExplainedScan {
  std::size_t scan = 0;
  LocalizeResult result;
  std::optional<Pose2> expected;  ///< the pose before, moved by the odometry
};

/// What happened to a whole log.
struct LocalizeRun {
  std::vector<TimedPose2> poses;         ///< one for each scan with a pose
  std::vector<std::size_t> scan_of;      ///< index into the log of each
  std::vector<LocalizeEvent> events;     ///< in order
  std::vector<Point2> readings;          ///< in the world; where they were asked for
  std::vector<double> milliseconds;      ///< of each scan
  std::vector<ExplainedScan> explained;  ///< the one that was asked for, and those of the search before it
  MatchCounts matches;                   ///< of all scans while there was a pose
  std::size_t beams = 0;                 ///< of all scans
  std::size_t lines = 0;                 ///< of all scans, with a pose or without
  std::size_t with_odometry = 0;         ///< scans
  std::size_t without_reading = 0;       ///< scans
  std::size_t lost_times = 0;
};

struct LocalizeRunOptions {
  LocalizeOptions localize;
  bool readings = false;
  std::optional<std::size_t> explain_scan;  ///< from 1; 0: the first that matched lines
};

/// Every scan through the localizer. `map` is in metres. Fails as Localizer::create does.
Result<LocalizeRun> run_localize(const LineMap& map, const LaserLog& log, const LocalizeRunOptions& options,
                                 Progress& progress);

/// The readings of a scan as points of the world; those that are none are left out.
std::vector<Point2> points_of(const LaserScan& scan, const Pose2& world_from_robot);

}  // namespace straightedge::cli
