// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "straightedge/host/pose2.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// Where a robot stood on the floor, and when.
struct TimedPose2 {
  double time_s = 0;
  Pose2 pose;                          ///< world_from_robot
  std::array<double, 9> covariance{};  ///< of (x, y, heading), row by row, metres and radians
};

/// TUM's format: a line `time tx ty tz qx qy qz qw` a pose, tz = qx = qy = 0. Numbers are the shortest that
/// read back to the same bits. Each line of `comment` is put before them behind a `#`.
std::string planar_trajectory_to_text(std::span<const TimedPose2> poses, const std::string& comment = {});

/// The covariances alone: a line `time xx xy xh yy yh hh` a pose, the upper triangle row by row; h is the
/// heading. A `#` line above them names the columns.
std::string covariances_to_text(std::span<const TimedPose2> poses, const std::string& comment = {});

/// Poses from lines of four numbers, `time x y theta`, or of eight as TUM has them, of which the turn about
/// the z axis is taken; the covariances are zero. Times must not run backwards.
///
/// cannot_read: the file cannot be opened. bad_content, with the line: other lines, numbers that are not
/// finite or beyond what a Pose2 may be, a quaternion whose length is not 1 (within 1e-2), no pose at all.
Result<std::vector<TimedPose2>> read_planar_trajectory(const std::filesystem::path& file);

}  // namespace straightedge
