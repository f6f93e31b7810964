// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "straightedge/host/pose2.hpp"

namespace straightedge {

/// One sweep of a laser scanner. Beam i points to first_angle_rad + i · angle_step_rad in the laser's frame:
/// x forward, counter-clockwise. Beams that reach once round (beams · |step| within half a step of 2 pi) make
/// a circle: the last is a neighbour of the first.
struct LaserScan {
  double time_s = 0;            ///< of the log
  double first_angle_rad = 0;   ///< of the first beam
  double angle_step_rad = 0;    ///< between beams; may be negative, must not be 0
  double max_range_m = 0;       ///< readings at or beyond it are none; 0 = not known
  std::vector<float> ranges_m;  ///< NaN, infinity, 0 and negative numbers are no readings
  Pose2 laser_in_robot;         ///< where the laser sits, robot_from_laser
};

}  // namespace straightedge
