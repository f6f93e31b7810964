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

/// The three formats are told apart by their content:
///  - TUM: `time tx ty tz qx qy qz qw` a line, `#` comments; times must not run backwards;
///  - Redwood `.log`: three integers, then a 4x4 matrix, again and again;
///  - 4x4 (or 3x4) matrices one after another; a single file with one matrix is one pose.
/// bad_content: a line that is none of these, numbers that are not finite, a quaternion or a matrix that is
/// no rotation (off by more than 1e-2; smaller faults are made good), a mirrored matrix.
Result<std::vector<TimedPose>> read_trajectory(const std::filesystem::path& file);

}  // namespace straightedge
