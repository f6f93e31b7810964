// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/plane_fit.hpp"

#include "covariance3.hpp"
#include "straightedge/square_root.hpp"
#include "straightedge/symmetric_eigen.hpp"
#include "tangents.hpp"

namespace straightedge {
namespace {

// Less scatter than this, relative to the sums it is the difference of, is rounding.
constexpr double rounding = 1e-12;

}  // namespace

Status fit_plane(const PlaneMoments& moments, PlaneFit& fit) noexcept {
  if (!(moments.weight > 0) || !(moments.count >= 3)) return Status::invalid_option;
  // Step 1.
  const Vector3 centroid = (1 / moments.weight) * Vector3{moments.x, moments.y, moments.z};
  // Step 2.
  const std::array<double, 6> scatter{
      moments.xx - moments.x * centroid.x, moments.xy - moments.x * centroid.y,
      moments.xz - moments.x * centroid.z, moments.yy - moments.y * centroid.y,
      moments.yz - moments.y * centroid.z, moments.zz - moments.z * centroid.z};
  for (const double s : scatter) {
    if (!(s < 1e300 && s > -1e300)) return Status::invalid_option;
  }
  // Step 3.
  const SymmetricEigen eigen = symmetric_eigen(scatter);
  const double least = eigen.values[0] > 0 ? eigen.values[0] : 0;
  const double wide = eigen.values[1] - least;
  const double widest = eigen.values[2] - least;
  const double squares = moments.xx + moments.yy + moments.zz;
  if (!(wide > rounding * squares)) return Status::invalid_option;
  PlaneFit found;
  found.plane = canonical({eigen.vectors[0], dot(eigen.vectors[0], centroid)});
  found.tangent_u = eigen.vectors[1];
  found.tangent_v = cross(found.plane.normal, found.tangent_u);
  found.centroid = centroid;
  // Step 4.
  const double var_u = 1 / wide;
  const double var_v = 1 / widest;
  const double mu = dot(found.tangent_u, centroid);
  const double mv = dot(found.tangent_v, centroid);
  found.covariance = {var_u, 0,          mu * var_u,
                      var_v, mv * var_v, 1 / moments.weight + mu * mu * var_u + mv * mv * var_v};
  found.weight = moments.weight;
  found.count = moments.count;
  found.rms = square_root(least / moments.weight);
  fit = found;
  return Status::ok;
}

void add_floor(PlaneFit& fit, const PlaneFloor& floor) noexcept {
  const double angle = floor.angle_rad * floor.angle_rad;
  const double mu = dot(fit.tangent_u, fit.centroid);
  const double mv = dot(fit.tangent_v, fit.centroid);
  fit.covariance[0] += angle;
  fit.covariance[2] += mu * angle;
  fit.covariance[3] += angle;
  fit.covariance[4] += mv * angle;
  fit.covariance[5] += floor.offset_m * floor.offset_m + (mu * mu + mv * mv) * angle;
}

std::array<double, 10> covariance_4x4(const PlaneFit& fit) noexcept {
  const Vector3& u = fit.tangent_u;
  const Vector3& v = fit.tangent_v;
  const auto& [uu, uv, ud, vv, vd, dd] = fit.covariance;
  // Rows of (u v) times the 2x2 block of the tangent errors.
  const Vector3 along_u = uu * u + uv * v;
  const Vector3 along_v = uv * u + vv * v;
  const Vector3 with_d = ud * u + vd * v;
  const auto entry = [&](double Vector3::*row, double Vector3::*column) noexcept {
    return u.*row * along_u.*column + v.*row * along_v.*column;
  };
  constexpr auto x = &Vector3::x;
  constexpr auto y = &Vector3::y;
  constexpr auto z = &Vector3::z;
  return {entry(x, x), entry(x, y), entry(x, z), with_d.x, entry(y, y),
          entry(y, z), with_d.y,    entry(z, z), with_d.z, dd};
}

PlaneFit moved(const PlaneFit& fit, const std::array<double, 9>& rotation, const Vector3& t) noexcept {
  const auto turn = [&](const Vector3& p) noexcept {
    const auto& r = rotation;
    return Vector3{r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
                   r[6] * p.x + r[7] * p.y + r[8] * p.z};
  };
  PlaneFit result = fit;
  result.tangent_u = turn(fit.tangent_u);
  detail::set_normal(result, normalized(turn(fit.plane.normal)));
  result.centroid = turn(fit.centroid) + t;
  result.plane.distance = fit.plane.distance + dot(result.plane.normal, t);
  // The distance from an origin that lies −t away turns with the normal's error.
  const detail::Rows3 jacobian{{1, 0, 0}, {0, 1, 0}, {dot(result.tangent_u, t), dot(result.tangent_v, t), 1}};
  result.covariance = detail::propagated(jacobian, fit.covariance);
  detail::make_canonical(result);
  return result;
}

}  // namespace straightedge
