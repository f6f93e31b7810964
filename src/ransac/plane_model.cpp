// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/plane_model.hpp"

namespace straightedge::ransac {
namespace {

/// Squared sine of the angle at a corner of the triangle below which three readings are on a line.
constexpr double least_sine_squared = 1e-6;

bool through_rays(const Reading& a, const Reading& b, const Reading& c, LinearPlane& plane) noexcept {
  const double u1 = b.x - a.x, v1 = b.y - a.y, q1 = b.z - a.z;
  const double u2 = c.x - a.x, v2 = c.y - a.y, q2 = c.z - a.z;
  const double area = u1 * v2 - u2 * v1;
  if (!(area * area > least_sine_squared * (u1 * u1 + v1 * v1) * (u2 * u2 + v2 * v2))) return false;
  const double slope_u = (q1 * v2 - q2 * v1) / area;
  const double slope_v = (u1 * q2 - u2 * q1) / area;
  plane = {-slope_u, -slope_v, 1, slope_u * a.x + slope_v * a.y - a.z};
  return true;
}

bool through_points(const Reading& a, const Reading& b, const Reading& c, LinearPlane& plane) noexcept {
  const Vector3 first{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vector3 second{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vector3 across = cross(first, second);
  if (!(squared_length(across) > least_sine_squared * squared_length(first) * squared_length(second)))
    return false;
  const Vector3 n = normalized(across);
  plane = {n.x, n.y, n.z, -dot(n, {a.x, a.y, a.z})};
  return true;
}

}  // namespace

bool plane_through(const Reading& a, const Reading& b, const Reading& c, bool in_space,
                   LinearPlane& plane) noexcept {
  return in_space ? through_points(a, b, c, plane) : through_rays(a, b, c, plane);
}

bool fit_model(const ModelSums& sums, const Readings& readings, LinearPlane& plane) noexcept {
  if (readings.in_space()) {
    PlaneFit fit;
    if (fit_plane(sums.space, fit) != Status::ok) return false;
    const Vector3& n = fit.plane.normal;
    plane = {n.x, n.y, n.z, -fit.plane.distance};
    return true;
  }
  InverseDepthFit fit;
  if (fit_inverse_depth(sums.inverse, readings.gate.inverse_sigma, fit) != Status::ok) return false;
  plane = {-fit.plane.a, -fit.plane.b, 1, -fit.plane.c};
  return true;
}

bool fit_found(const ModelSums& sums, const Readings& readings, PlaneFit& fit) noexcept {
  if (readings.in_space()) {
    if (fit_plane(sums.space, fit) != Status::ok) return false;
    fit = moved(fit, {1, 0, 0, 0, 1, 0, 0, 0, 1}, readings.origin);
    return true;
  }
  return fit_rays(sums.inverse, readings, fit);
}

bool fit_rays(const InverseDepthMoments& sums, const Readings& readings, PlaneFit& fit) noexcept {
  const double sigma = readings.gate.inverse_sigma;
  InverseDepthFit inverse;
  return fit_inverse_depth(sums, sigma, inverse) == Status::ok &&
         to_plane_fit(inverse, sigma, readings.camera, fit) == Status::ok;
}

LinearPlane to_linear(const Plane& plane, const Readings& readings) noexcept {
  if (readings.in_space()) {
    const Vector3& n = plane.normal;
    return {n.x, n.y, n.z, dot(n, readings.origin) - plane.distance};
  }
  const InverseDepthPlane p = to_inverse_depth(plane, readings.camera);
  return {-p.a, -p.b, 1, -p.c};
}

}  // namespace straightedge::ransac
