// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "localize/wall_map.hpp"
#include "straightedge/host/localizer.hpp"

namespace straightedge::localize {

/// A reading to judge a pose by: where it ended, in the robot's frame.
struct Reading {
  double x_m = 0, y_m = 0;
};

/// Some readings of a scan, spread evenly over its order.
struct Readings {
  std::vector<Reading> ends;
  double laser_x_m = 0, laser_y_m = 0;
};

void choose_readings(std::span<const ScanPoint> points, const Pose2& laser_in_robot, std::size_t most,
                     Readings& readings);

struct PoseScore {
  ScanFit fit;
  double log_likelihood = 0;  ///< a sum over the readings, discounted: neighbours say the same
};

/// Step 5 of localizer.hpp: each reading's beam in the map. `tolerance_m`: how near a wall a reading lies on
/// it. A reading's log likelihood: −½ (distance / ½ tolerance)² on a wall; fixed values where it ends before
/// walls, where the map has none, and, least likely, behind one.
PoseScore score_pose(const WallMap& map, const Pose2& pose, const Readings& readings, double tolerance_m);

}  // namespace straightedge::localize
