// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/pose_belief.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge::localize {
namespace {

// Tyres and floors change: so much of what was learnt of the odometry's faults is forgotten a metre.
constexpr double forgotten_per_m = 1e-3;

struct Step {
  Pose2 motion;
  double way = 0;  // metres of odometry, 0 without
  double way_sigma = 0;
  double turn_sigma = 0;
};

void forget_faults(StateMatrix& covariance, double way, const MotionOptions& options) {
  const double usual[] = {options.scale, options.drift_per_m};
  for (std::size_t i = 0; i < 2; ++i) {
    const double most = usual[i] * usual[i];
    double& variance = covariance(3 + i, 3 + i);
    variance = std::max(variance, std::min(most, variance + forgotten_per_m * way * most));
  }
}

/// x' = pose + R(heading) d. The noise is that of the motion (along, across, turn); half of the turn's error
/// has gone before the way, which it bends.
void move(PoseBelief& belief, const Step& step) {
  const SineCosine turn = sine_cosine(belief.pose.heading_rad);
  const double c = turn.cosine, s = turn.sine;
  const double x = c * step.motion.x_m - s * step.motion.y_m, y = s * step.motion.x_m + c * step.motion.y_m;
  const double grown = 1 / (1 + belief.scale);
  const StateMatrix f{{1, 0, -y, x * grown, -0.5 * y * step.way,  //
                       0, 1, x,  y * grown, 0.5 * x * step.way,   //
                       0, 0, 1,  0,         step.way,             //
                       0, 0, 0,  1,         0,                    //
                       0, 0, 0,  0,         1}};
  const Matrix<state_size, 3> g{{c, -s, -0.5 * y, s, c, 0.5 * x, 0, 0, 1, 0, 0, 0, 0, 0, 0}};
  const double way = step.way_sigma * step.way_sigma;
  const Matrix3 q{{way, 0, 0, 0, way, 0, 0, 0, step.turn_sigma * step.turn_sigma}};
  belief.covariance = f * belief.covariance * transposed(f) + g * q * transposed(g);
  make_symmetric(belief.covariance);
  for (ConsideredLine& line : belief.considered) line.covariance = f * line.covariance;
  belief.pose = compose(belief.pose, step.motion);
}

}  // namespace

const StateWithLine* PoseBelief::with(std::uint32_t line) const {
  for (const ConsideredLine& c : considered) {
    if (c.line == line) return &c.covariance;
  }
  return nullptr;
}

PoseBelief belief_at(const Pose2& pose, const Matrix3& covariance, const MotionOptions& options) {
  PoseBelief belief;
  belief.pose = pose;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) belief.covariance(r, c) = covariance(r, c);
  }
  belief.covariance(3, 3) = options.scale * options.scale;
  belief.covariance(4, 4) = options.drift_per_m * options.drift_per_m;
  return belief;
}

Matrix3 pose_covariance(const PoseBelief& belief) {
  Matrix3 out;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) out(r, c) = belief.covariance(r, c);
  }
  return out;
}

void predict(PoseBelief& belief, const Pose2& motion, const MotionOptions& options) {
  const double way = std::sqrt(motion.x_m * motion.x_m + motion.y_m * motion.y_m);
  const double turn = std::fabs(wrap_angle(motion.heading_rad));
  // The bent way starts in a direction turned by half of the bend.
  const double bend = belief.drift * way;
  const Pose2 straight = compose({0, 0, 0.5 * bend}, motion);
  const double scale = 1 + belief.scale;
  move(belief, {{scale * straight.x_m, scale * straight.y_m, motion.heading_rad + bend},
                way,
                options.along_per_m * way + options.along_per_rad * turn + options.along_m,
                options.turn_per_rad * turn + options.turn_per_m * way + options.turn_rad});
  forget_faults(belief.covariance, way, options);
}

void predict_blindly(PoseBelief& belief, const Pose2& last_motion, double times,
                     const MotionOptions& options) {
  const double wider = std::max(1.0, times);
  // A turn that goes on bends the way: half of the further turn, on average.
  const double further_rad = (times - 1) * last_motion.heading_rad;
  Pose2 motion = compose({0, 0, 0.5 * further_rad}, {times * last_motion.x_m, times * last_motion.y_m, 0});
  motion.heading_rad = wrap_angle(times * last_motion.heading_rad);
  move(belief, {motion, 0, wider * options.unknown_m, wider * options.unknown_rad});
}

}  // namespace straightedge::localize
