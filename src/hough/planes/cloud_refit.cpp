// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/cloud_job.hpp"

namespace straightedge::hough {
namespace {

constexpr int passes = 4;
constexpr double steps_at_first = 1.5;

/// How far a point may lie from a plane that passes the sensor at this distance. Without a fixed threshold
/// the gate is one of 1/z, and |n·p − d| = z d times the residual of 1/z.
double limit_at(const PlaneGate& gate, const Vector3& point, double sensor_distance) noexcept {
  if (gate.fixed_m > 0) return gate.fixed_m;
  if (!(point.z > 0)) return -1;
  return gate.sigmas * gate.inverse_noise(1 / point.z) * point.z * sensor_distance;
}

/// Labels the free points near the plane, and takes the label from those that are not. Returns how many.
std::uint32_t label_near(CloudJob& job, const Plane& plane, double more, PlaneMoments& moments,
                         double& limits) noexcept {
  const double to_sensor = plane.distance + dot(plane.normal, job.origin);
  const double sensor_distance = to_sensor < 0 ? -to_sensor : to_sensor;
  const auto label = static_cast<std::uint16_t>(job.found + 1);
  std::uint32_t count = 0;
  moments = {};
  limits = 0;
  for (std::size_t i = 0; i < job.left; ++i) {
    const Vector3 p = job.at(i);
    const double off = plane.signed_distance(p);
    const double limit = limit_at(job.options.gate, p + job.origin, sensor_distance);
    const bool near = limit >= 0 && off <= limit + more && off >= -limit - more;
    job.labels[job.memory.free[i]] = near ? label : std::uint16_t{0};
    if (!near) continue;
    ++count;
    moments.add(p);
    limits += limit;
  }
  return count;
}

/// Points on a line, or on a strip that is no wider than the gate, are no plane.
bool wide_enough(const PlaneMoments& moments, double limit, PlaneFit& fit) noexcept {
  if (fit_plane(moments, fit) != Status::ok) return false;
  // With weights of 1 the first variance is 1 / (l2 − l1), the scatter across in the plane.
  const double scatter = 1 / fit.covariance[0];
  return scatter > limit * limit * moments.weight;
}

}  // namespace

bool refit_peak(CloudJob& job, const Plane& plane) noexcept {
  Plane current = plane;
  bool found = false;
  for (int pass = 0; pass < passes; ++pass) {
    const double more = pass == 0 ? steps_at_first * job.memory.accumulator.step_m() : 0;
    PlaneMoments moments;
    double limits = 0;
    const std::uint32_t count = label_near(job, current, more, moments, limits);
    PlaneFit fit;
    found = count >= job.options.min_points && wide_enough(moments, limits / count, fit);
    if (!found) break;
    job.planes[job.found] = {.fit = fit, .inliers = count};
    current = fit.plane;
  }
  if (found) {
    FoundPlane& done = job.planes[job.found];
    done.fit = moved(done.fit, {1, 0, 0, 0, 1, 0, 0, 0, 1}, job.origin);
    return true;
  }
  for (std::size_t i = 0; i < job.left; ++i) job.labels[job.memory.free[i]] = 0;
  return false;
}

void drop_labelled(CloudJob& job) noexcept {
  detail::HoughPlaneMemory& m = job.memory;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < job.left; ++i) {
    if (job.labels[m.free[i]] != 0) continue;
    m.x[kept] = m.x[i];
    m.y[kept] = m.y[i];
    m.z[kept] = m.z[i];
    m.free[kept++] = m.free[i];
  }
  job.left = kept;
}

}  // namespace straightedge::hough
