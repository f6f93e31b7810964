// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

struct TimedPose {
  std::optional<double> time;  ///< seconds; none in formats without times
  Pose pose;
};

/// Poses, camera to world, from a text file. The formats are told apart by the first line that is neither
/// empty nor a `#` comment:
///  - TUM: `time tx ty tz qx qy qz qw` a line; times must not run backwards. Without times, seven numbers a
///    line, as some sets have it;
///  - Redwood `.log`: three integers, then a 4x4 matrix, again and again;
///  - 4x4 or 3x4 matrices one after another, a row or a whole matrix a line. One matrix is one pose.
///
/// Numbers may lie far out: a camera a kilometre away is a camera. Rotations are made exact: quaternions by
/// their length, matrices by Newton's method for the nearest rotation, R <- (R + R^-T)/2, five steps (Higham,
/// SIAM J. Sci. Stat. Comput. 7(4), 1986, 10.1137/0907079).
///
/// cannot_read: the file cannot be opened. bad_content, with the line: a line that is none of these, numbers
/// that are not finite, a quaternion or a matrix that is no rotation (off by more than 1e-2 in length or in
/// an entry of R^T R; smaller faults are made good), a mirrored matrix, no pose at all.
Result<std::vector<TimedPose>> read_trajectory(const std::filesystem::path& file);

}  // namespace straightedge
