// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/line_fit.hpp"

#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

// Less scatter than this, relative to the sums it is the difference of, is rounding.
constexpr double rounding = 1e-12;

}  // namespace

Status fit_line(const LineMoments& moments, LineFit& fit) noexcept {
  if (!(moments.weight > 0) || !(moments.count >= 2)) return Status::invalid_option;
  // Step 1.
  const double mx = moments.x / moments.weight;
  const double my = moments.y / moments.weight;
  // Step 2.
  const double a = moments.xx - moments.x * mx;
  const double b = moments.xy - moments.x * my;
  const double c = moments.yy - moments.y * my;
  if (!(a + c > rounding * (moments.xx + moments.yy)) || !(a + c < 1e300) || !(b - b == 0)) {
    return Status::invalid_option;
  }
  // Step 3. Half of −pi is the same line as half of pi.
  const double half = 0.5 * arc_tangent(-2 * b, c - a);
  const double theta = half <= -pi / 2 ? pi / 2 : half;
  const SineCosine normal = sine_cosine(theta);
  // Step 4.
  const double nx = normal.cosine;
  const double ny = normal.sine;
  const double across = nx * nx * a + 2 * nx * ny * b + ny * ny * c;
  const double along = a + c - across;
  if (!(along > 0)) return Status::invalid_option;
  fit.theta = theta;
  fit.normal_x = nx;
  fit.normal_y = ny;
  fit.centroid_x = mx;
  fit.centroid_y = my;
  fit.var_theta = 1 / along;
  fit.var_offset = 1 / moments.weight;
  fit.residual = across > 0 ? square_root(across / moments.weight) : 0;
  return Status::ok;
}

void add_floor(LineFit& fit, double length, const LineFloor& floor) noexcept {
  const double angle = floor.angle_length / (length > 1 ? length : 1);
  fit.var_theta += angle * angle;
  fit.var_offset += floor.offset * floor.offset;
}

double line_chi_square(const LineFit& a, const LineFit& b) noexcept {
  const double mid_x = 0.5 * (a.centroid_x + b.centroid_x);
  const double mid_y = 0.5 * (a.centroid_y + b.centroid_y);
  const double side = a.normal_x * b.normal_x + a.normal_y * b.normal_y < 0 ? -1 : 1;
  // Difference of angle and of offset at the midpoint, in the frame of line a.
  const double angle = arc_tangent(side * (a.normal_x * b.normal_y - a.normal_y * b.normal_x),
                                   side * (a.normal_x * b.normal_x + a.normal_y * b.normal_y));
  const double offset = side * b.distance(mid_x, mid_y) - a.distance(mid_x, mid_y);
  // Each line's variance carried from its centroid to the midpoint: lever = way along the line.
  const double lever_a = -(mid_x - a.centroid_x) * a.normal_y + (mid_y - a.centroid_y) * a.normal_x;
  const double lever_b = side * (-(mid_x - b.centroid_x) * b.normal_y + (mid_y - b.centroid_y) * b.normal_x);
  const double tt = a.var_theta + b.var_theta;
  const double to = lever_a * a.var_theta + lever_b * b.var_theta;
  const double oo =
      a.var_offset + b.var_offset + lever_a * lever_a * a.var_theta + lever_b * lever_b * b.var_theta;
  const double determinant = tt * oo - to * to;
  if (!(determinant > 0)) return 1e300;
  return (angle * angle * oo - 2 * angle * offset * to + offset * offset * tt) / determinant;
}

}  // namespace straightedge
