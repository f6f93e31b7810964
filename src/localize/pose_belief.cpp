// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/pose_belief.hpp"

#include <cmath>

namespace straightedge::localize {
namespace {

/// x' = pose + R(heading) d. The noise is that of the motion (along, across, turn); half of the turn's error
/// has gone before the way, which it bends.
void move(PoseBelief& belief, const Pose2& motion, double way_sigma, double turn_sigma) {
  const SineCosine turn = sine_cosine(belief.pose.heading_rad);
  const double c = turn.cosine, s = turn.sine;
  const double bend_x = -s * motion.x_m - c * motion.y_m;
  const double bend_y = c * motion.x_m - s * motion.y_m;
  const Matrix3 f{{1, 0, bend_x, 0, 1, bend_y, 0, 0, 1}};
  const Matrix3 g{{c, -s, 0.5 * bend_x, s, c, 0.5 * bend_y, 0, 0, 1}};
  const double way = way_sigma * way_sigma;
  const Matrix3 q{{way, 0, 0, 0, way, 0, 0, 0, turn_sigma * turn_sigma}};
  belief.covariance = f * belief.covariance * transposed(f) + g * q * transposed(g);
  make_symmetric(belief.covariance);
  for (Matrix<3, 2>& line : belief.with_lines) line = f * line;
  belief.pose = compose(belief.pose, motion);
}

}  // namespace

void predict(PoseBelief& belief, const Pose2& motion, const MotionOptions& options) {
  const double way = std::sqrt(motion.x_m * motion.x_m + motion.y_m * motion.y_m);
  const double turn = std::fabs(wrap_angle(motion.heading_rad));
  move(belief, motion, options.along_per_m * way + options.along_per_rad * turn + options.along_m,
       options.turn_per_rad * turn + options.turn_per_m * way + options.turn_rad);
}

void predict_blindly(PoseBelief& belief, const Pose2& last_motion, const MotionOptions& options) {
  move(belief, last_motion, options.unknown_m, options.unknown_rad);
}

}  // namespace straightedge::localize
