// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "localize/matrix.hpp"
#include "straightedge/host/localize_options.hpp"
#include "straightedge/host/pose2.hpp"

namespace straightedge::localize {

/// What the filter knows: a pose, how sure it is, and how its error depends on that of each map line.
struct PoseBelief {
  Pose2 pose;
  Matrix3 covariance;
  /// Covariance of (x, y, heading) with (angle, offset) of each line of the map; none before the first
  /// correction.
  std::vector<Matrix<3, 2>> with_lines;
};

/// Step 2 of localizer.hpp. `motion` in the frame of the pose before it.
void predict(PoseBelief& belief, const Pose2& motion, const MotionOptions& options);

/// Without odometry: the last motion again, with wide noise.
void predict_blindly(PoseBelief& belief, const Pose2& last_motion, const MotionOptions& options);

}  // namespace straightedge::localize
