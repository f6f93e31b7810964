// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/fit_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

// The weights depend on the direction of the line, which depends little on the weights.
constexpr int weighted_rounds = 2;

/// 1 / variance of a reading along the normal.
double weight_of(const ScanPoint& p, const Laser& laser, const LineFit& fit, const ScanLineOptions& options) {
  const double ux = (p.x_m - laser.x_m) / p.range_m;
  const double uy = (p.y_m - laser.y_m) / p.range_m;
  const double along = (fit.normal_x * ux + fit.normal_y * uy) * options.range_sigma_m;
  const double across = (fit.normal_y * ux - fit.normal_x * uy) * p.range_m * options.bearing_sigma_rad;
  // A wall seen along the beams has no range noise across it; a millimetre keeps its weights finite.
  return 1 / (along * along + across * across + 1e-6);
}

LineMoments moments_of(std::span<const ScanPoint> points, std::span<const std::uint32_t> members,
                       const Laser& laser, const LineFit* direction, const ScanLineOptions& options) {
  LineMoments moments;
  const ScanPoint& origin = points[members.front()];
  for (const std::uint32_t i : members) {
    const double weight = direction != nullptr ? weight_of(points[i], laser, *direction, options) : 1;
    moments.add(points[i].x_m - origin.x_m, points[i].y_m - origin.y_m, weight);
  }
  return moments;
}

}  // namespace

bool fit_points(std::span<const ScanPoint> points, std::span<const std::uint32_t> members, const Laser& laser,
                const ScanLineOptions& options, LineFit& fit) {
  if (members.size() < 2) return false;
  LineMoments moments = moments_of(points, members, laser, nullptr, options);
  if (fit_line(moments, fit) != Status::ok) return false;
  for (int round = 0; round < weighted_rounds; ++round) {
    moments = moments_of(points, members, laser, &fit, options);
    if (fit_line(moments, fit) != Status::ok) return false;
  }
  const ScanPoint& origin = points[members.front()];
  fit.centroid_x += origin.x_m;
  fit.centroid_y += origin.y_m;
  // Points that scatter more than their noise says (rough walls, curtains) know their line less well.
  const double freedom = std::max(1.0, moments.count - 2);
  const double excess = fit.residual * fit.residual * moments.weight / freedom;
  if (excess > 1) {
    fit.var_theta *= excess;
    fit.var_offset *= excess;
  }
  return true;
}

ScanLine line_of(std::span<const ScanPoint> points, std::span<const std::uint32_t> members,
                 const Laser& laser, const ScanLineOptions& options, const LineFit& fit) {
  ScanLine line;
  // The normal points to the laser.
  const double side = fit.distance(laser.x_m, laser.y_m) < 0 ? -1 : 1;
  line.normal_x = side * fit.normal_x;
  line.normal_y = side * fit.normal_y;
  line.theta_rad = wrap_angle(side < 0 ? fit.theta + pi : fit.theta);
  line.centroid_x_m = fit.centroid_x;
  line.centroid_y_m = fit.centroid_y;
  line.var_theta = fit.var_theta + options.angle_floor_rad * options.angle_floor_rad;
  line.var_offset = fit.var_offset + options.offset_floor_m * options.offset_floor_m;
  line.residual_m = fit.residual;
  // The floor is on the left of the way from end 0 to end 1.
  const double tx = line.normal_y, ty = -line.normal_x;
  double begin = 1e300, end = -1e300;
  for (const std::uint32_t i : members) {
    const double s = (points[i].x_m - fit.centroid_x) * tx + (points[i].y_m - fit.centroid_y) * ty;
    begin = std::min(begin, s);
    end = std::max(end, s);
  }
  line.x0_m = fit.centroid_x + begin * tx;
  line.y0_m = fit.centroid_y + begin * ty;
  line.x1_m = fit.centroid_x + end * tx;
  line.y1_m = fit.centroid_y + end * ty;
  line.first_beam = points[members.front()].beam;
  line.last_beam = points[members.back()].beam;
  line.points = static_cast<std::uint32_t>(members.size());
  return line;
}

}  // namespace straightedge::localize
