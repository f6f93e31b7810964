// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/line_pair.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

double half_turn_wrapped(double angle) {
  const double wrapped = wrap_angle(angle);
  if (wrapped > pi / 2) return wrapped - pi;
  return wrapped <= -pi / 2 ? wrapped + pi : wrapped;
}

Matrix2 covariance_of(const Wall& wall) {
  return {{wall.var_theta, 0, 0, wall.var_offset}};
}

Matrix2 sum_covariance(const LinePair& pair, const PoseBelief& belief, const Wall& wall) {
  const Matrix<2, state_size> h = by_state(pair, wall);
  Matrix2 s = h * belief.covariance * transposed(h) + own_covariance(pair, wall);
  if (const StateWithLine* with = belief.with(wall.line)) {
    const Matrix2 cross = h * *with * transposed(by_wall(pair));
    s += cross + transposed(cross);
  }
  return s;
}

}  // namespace

LinePair make_pair(const Pose2& pose, const ScanLine& line, std::uint32_t line_index, const WallMap& map,
                   std::uint32_t wall_index) {
  const Wall& wall = map.walls()[wall_index];
  const SineCosine turn = sine_cosine(pose.heading_rad);
  const double cx = turn.cosine * line.centroid_x_m - turn.sine * line.centroid_y_m;
  const double cy = turn.sine * line.centroid_x_m + turn.cosine * line.centroid_y_m;
  LinePair pair;
  pair.line = line_index;
  pair.wall = wall_index;
  pair.angle = half_turn_wrapped(wall.theta - line.theta_rad - pose.heading_rad);
  pair.offset = wall.across(pose.x_m + cx, pose.y_m + cy);
  pair.offset_by_heading = -cy * wall.nx + cx * wall.ny;
  pair.lever = wall.along(pose.x_m + cx, pose.y_m + cy);
  // A wall that steps by pixels: the piece in sight may lie beside the line and be turned, the shorter the
  // more.
  const double dx = line.x1_m - line.x0_m, dy = line.y1_m - line.y0_m;
  const double rough = map.roughness_m();
  pair.var_theta = line.var_theta + 4 * rough * rough / std::max(1e-6, dx * dx + dy * dy);
  pair.var_offset = line.var_offset + rough * rough;
  return pair;
}

Matrix<2, state_size> by_state(const LinePair& pair, const Wall& wall) {
  return {{0, 0, -1, 0, 0, wall.nx, wall.ny, pair.offset_by_heading, 0, 0}};
}

Matrix2 by_wall(const LinePair& pair) {
  return {{1, 0, pair.lever, -1}};
}

Matrix2 own_covariance(const LinePair& pair, const Wall& wall) {
  const Matrix2 j = by_wall(pair);
  Matrix2 own = j * covariance_of(wall) * transposed(j);
  own(0, 0) += pair.var_theta;
  own(1, 1) += pair.var_offset;
  return own;
}

bool judge_pair(LinePair& pair, const PoseBelief& belief, const Wall& wall) {
  pair.s = sum_covariance(pair, belief, wall);
  Matrix2 inverse;
  if (!invert(pair.s, inverse)) return false;
  pair.chi_square = pair.angle * pair.angle * inverse(0, 0) + pair.offset * pair.offset * inverse(1, 1) +
                    pair.angle * pair.offset * (inverse(0, 1) + inverse(1, 0));
  return pair.chi_square >= 0;
}

void correct(PoseBelief& belief, const LinePair& pair, const WallMap& map) {
  const Wall& wall = map.walls()[pair.wall];
  Matrix2 inverse;
  if (!invert(pair.s, inverse)) return;
  const Matrix<2, state_size> h = by_state(pair, wall);
  const Matrix2 j = by_wall(pair);
  if (belief.with(wall.line) == nullptr) belief.considered.push_back({wall.line, {}});
  const StateWithLine with_errors =
      belief.covariance * transposed(h) + *belief.with(wall.line) * transposed(j);
  const StateWithLine gain = with_errors * inverse;
  const Matrix<2, 1> errors{{pair.angle, pair.offset}};
  const Matrix<state_size, 1> step = gain * errors;
  belief.pose.x_m -= step.v[0];
  belief.pose.y_m -= step.v[1];
  belief.pose.heading_rad = wrap_angle(belief.pose.heading_rad - step.v[2]);
  belief.scale -= step.v[3];
  belief.drift -= step.v[4];
  belief.covariance -= gain * transposed(with_errors);
  make_symmetric(belief.covariance);
  for (ConsideredLine& considered : belief.considered) {
    Matrix2 seen = h * considered.covariance;
    if (considered.line == wall.line) seen += j * covariance_of(wall);
    considered.covariance -= gain * seen;
  }
}

}  // namespace straightedge::localize
