// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "localize/matrix.hpp"
#include "straightedge/host/localize_options.hpp"
#include "straightedge/host/pose2.hpp"

namespace straightedge::localize {

/// Estimated: x, y, heading (metres, radians, world), and the odometry's own faults: its scale error and its
/// drift, radians for each metre. Uneven tyres make every metre too long and bend every way, always alike, so
/// what the walls teach about them helps where there are none (J. Borenstein, L. Feng, 1996,
/// doi:10.1109/70.544770).
inline constexpr std::size_t state_size = 5;
using StateMatrix = Matrix<state_size, state_size>;
using StateWithLine = Matrix<state_size, 2>;

/// How the error of the state hangs together with that of a map line.
struct ConsideredLine {
  std::uint32_t line = 0;
  StateWithLine covariance;  ///< of the state with the line's (angle, offset)
};

/// What the filter knows: a pose, how sure it is, and how its error depends on those of the map lines that
/// have corrected it.
struct PoseBelief {
  Pose2 pose;
  double scale = 0;  ///< true way = (1 + scale) · the odometry's
  double drift = 0;  ///< true turn = the odometry's + drift · way
  StateMatrix covariance;
  std::vector<ConsideredLine> considered;

  /// Null for a line that has not corrected the pose lately.
  const StateWithLine* with(std::uint32_t line) const;
};

/// Nothing known of the odometry but how good it usually is.
PoseBelief belief_at(const Pose2& pose, const Matrix3& covariance, const MotionOptions& options);

/// Of x, y and heading.
Matrix3 pose_covariance(const PoseBelief& belief);

/// Forgets the lines that the state has hardly anything to do with any more: all correlations below 1 %.
/// `variance(line)` gives (angle, offset) of a line as a pair.
template <class Variance>
void forget_far_lines(PoseBelief& belief, const Variance& variance) {
  constexpr double least = 0.01 * 0.01;
  std::erase_if(belief.considered, [&](const ConsideredLine& considered) {
    const auto [angle, offset] = variance(considered.line);
    for (std::size_t i = 0; i < state_size; ++i) {
      const double own = belief.covariance(i, i);
      const double a = considered.covariance(i, 0), o = considered.covariance(i, 1);
      if (a * a > least * own * angle || o * o > least * own * offset) return false;
    }
    return true;
  });
}

/// Step 2 of localizer.hpp. `motion` in the frame of the pose before it.
void predict(PoseBelief& belief, const Pose2& motion, const MotionOptions& options);

/// Without odometry: the last motion again, with wide noise. `times`: how many times as long as the last step
/// this one took.
void predict_blindly(PoseBelief& belief, const Pose2& last_motion, double times,
                     const MotionOptions& options);

}  // namespace straightedge::localize
