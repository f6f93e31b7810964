// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>

#include "covariance3.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"
#include "tangents.hpp"

namespace straightedge {
namespace {

/// Two planes seen from a point between them, errors in the tangents of the first.
struct Comparison {
  Vector3 origin;
  Vector3 difference;  ///< second − first: two angles, distance from the origin
  double first_distance = 0;
  detail::Upper3 first{}, second{};  ///< covariances
};

/// The covariance seen from another origin, in the same tangents.
detail::Upper3 seen_from(const PlaneFit& fit, const Vector3& origin) noexcept {
  return detail::propagated(
      {{1, 0, 0}, {0, 1, 0}, {-dot(fit.tangent_u, origin), -dot(fit.tangent_v, origin), 1}}, fit.covariance);
}

Comparison compare(const PlaneFit& a, const PlaneFit& b) noexcept {
  Comparison c;
  // Turning b's normal turns the errors of its normal and of its distance alike: the covariance stays.
  const double side = dot(a.plane.normal, b.plane.normal) < 0 ? -1 : 1;
  const Vector3 b_normal = side * b.plane.normal;
  c.origin = 0.5 * (a.centroid + b.centroid);
  const double sine = length(cross(a.plane.normal, b_normal));
  const double angle = arc_tangent(sine, dot(a.plane.normal, b_normal));
  const double stretch = sine > 0 ? angle / sine : 1;
  c.first_distance = -a.plane.signed_distance(c.origin);
  c.difference = {stretch * dot(a.tangent_u, b_normal), stretch * dot(a.tangent_v, b_normal),
                  -side * b.plane.signed_distance(c.origin) - c.first_distance};
  c.first = seen_from(a, c.origin);
  const detail::Rows3 into_tangents_of_a{{dot(a.tangent_u, b.tangent_u), dot(a.tangent_u, b.tangent_v), 0},
                                         {dot(a.tangent_v, b.tangent_u), dot(a.tangent_v, b.tangent_v), 0},
                                         {0, 0, 1}};
  c.second = detail::propagated(into_tangents_of_a, seen_from(b, c.origin));
  return c;
}

/// What of the fused plane is a weighted mean of both.
void average(const PlaneFit& a, const PlaneFit& b, PlaneFit& fused) noexcept {
  fused.weight = a.weight + b.weight;
  fused.count = a.count + b.count;
  const double share = fused.weight > 0 ? b.weight / fused.weight : 0.5;
  fused.centroid = (1 - share) * a.centroid + share * b.centroid;
  fused.rms = square_root((1 - share) * a.rms * a.rms + share * b.rms * b.rms);
}

}  // namespace

double plane_chi_square(const PlaneFit& a, const PlaneFit& b) noexcept {
  if (a.plane == b.plane) return 0;
  const Comparison c = compare(a, b);
  constexpr double never = std::numeric_limits<double>::infinity();
  detail::Factored3 together;
  if (!detail::factor(detail::sum(c.first, c.second), together)) return never;
  const double distance = dot(c.difference, together.solve(c.difference));
  return distance >= 0 ? distance : never;
}

Status fuse_planes(const PlaneFit& a, const PlaneFit& b, PlaneFit& fused) noexcept {
  const Comparison c = compare(a, b);
  detail::Factored3 first, second, together;
  if (!detail::factor(c.first, first) || !detail::factor(c.second, second)) return Status::invalid_option;
  const detail::Upper3 information = detail::sum(first.inverse(), second.inverse());
  if (!detail::factor(information, together)) return Status::invalid_option;
  const Vector3 step = together.solve(second.solve(c.difference));
  if (!finite(step)) return Status::invalid_option;
  PlaneFit result = a;
  average(a, b, result);
  detail::set_normal(result, normalized(a.plane.normal + step.x * a.tangent_u + step.y * a.tangent_v));
  // Back to the frame's origin.
  result.plane.distance = c.first_distance + step.z + dot(result.plane.normal, c.origin);
  result.covariance = detail::propagated(
      {{1, 0, 0}, {0, 1, 0}, {dot(result.tangent_u, c.origin), dot(result.tangent_v, c.origin), 1}},
      together.inverse());
  detail::make_canonical(result);
  fused = result;
  return Status::ok;
}

}  // namespace straightedge
