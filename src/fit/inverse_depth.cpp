// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/inverse_depth.hpp"

#include "covariance3.hpp"
#include "straightedge/square_root.hpp"
#include "tangents.hpp"

namespace straightedge {
namespace {

// Less scatter than this, relative to the sums it is the difference of, is rounding.
constexpr double rounding = 1e-12;

/// Some vector that is no multiple of the normal.
Vector3 aside(const Vector3& n) noexcept {
  const double x = n.x * n.x, y = n.y * n.y, z = n.z * n.z;
  if (x <= y && x <= z) return {1, 0, 0};
  return y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
}

}  // namespace

Status fit_inverse_depth(const InverseDepthMoments& moments, double sigma, InverseDepthFit& fit) noexcept {
  const InverseDepthMoments& m = moments;
  if (!(m.n >= 3) || !(sigma > 0) || !(sigma < 1e100)) return Status::invalid_option;
  // Step 1.
  const double mean_u = m.u / m.n, mean_v = m.v / m.n, mean_q = m.q / m.n;
  const double uu = m.uu - m.u * mean_u, uv = m.uv - m.u * mean_v, vv = m.vv - m.v * mean_v;
  const double uq = m.uq - m.u * mean_q, vq = m.vq - m.v * mean_q, qq = m.qq - m.q * mean_q;
  const double determinant = uu * vv - uv * uv;
  // The least extent of the pixels across any line.
  if (!(determinant > rounding * (m.uu + m.vv) * (uu + vv)) || !(determinant < 1e300)) {
    return Status::invalid_option;
  }
  // Step 2.
  InverseDepthFit found;
  const double a = (uq * vv - vq * uv) / determinant;
  const double b = (vq * uu - uq * uv) / determinant;
  found.plane = {a, b, mean_q - a * mean_u - b * mean_v};
  const double left = qq - a * uq - b * vq;
  if (!(found.plane.c - found.plane.c == 0) || !(left - left == 0)) return Status::invalid_option;
  // Step 3.
  const double variance = sigma * sigma;
  const double aa = variance * vv / determinant;
  const double ab = -variance * uv / determinant;
  const double bb = variance * uu / determinant;
  const double ac = -(aa * mean_u + ab * mean_v);
  const double bc = -(ab * mean_u + bb * mean_v);
  found.covariance = {aa, ab, ac, bb, bc, variance / m.n - ac * mean_u - bc * mean_v};
  found.mean_u = mean_u;
  found.mean_v = mean_v;
  found.n = m.n;
  found.rms = left > 0 ? square_root(left / m.n) : 0;
  fit = found;
  return Status::ok;
}

Status to_plane_fit(const InverseDepthFit& fit, double sigma, const PinholeCamera& camera,
                    PlaneFit& plane) noexcept {
  if (!camera.valid() || !(sigma > 0) || !(sigma < 1e100) || !(fit.n >= 3)) return Status::invalid_option;
  const auto& [a, b, c] = fit.plane;
  // n·X = d divided by d: m·X = 1, and 1/z = m·r.
  const Vector3 m{a * camera.fx, b * camera.fy, c + a * camera.cx + b * camera.cy};
  const double inverse_z = fit.plane.at(fit.mean_u, fit.mean_v);
  const double size = length(m);
  if (!(inverse_z > 0) || !(size < 1e100)) return Status::invalid_option;
  PlaneFit found;
  const double d = 1 / size;
  const double z = 1 / inverse_z;
  const Vector3 normal = d * m;
  found.tangent_u = aside(normal);
  detail::set_normal(found, normal);
  found.plane.distance = d;
  found.centroid = z * camera.ray(fit.mean_u, fit.mean_v);
  // dn = d (I − n nᵀ) dm, dd = −d² n·dm, and m is linear in (a, b, c).
  const auto by_coefficients = [&](double scale, const Vector3& along) noexcept {
    return scale * Vector3{along.x * camera.fx + along.z * camera.cx,
                           along.y * camera.fy + along.z * camera.cy, along.z};
  };
  found.covariance =
      detail::propagated({by_coefficients(d, found.tangent_u), by_coefficients(d, found.tangent_v),
                          by_coefficients(-d * d, normal)},
                         fit.covariance);
  const double sigma_z = sigma * z * z;
  found.weight = fit.n / (sigma_z * sigma_z);
  found.count = fit.n;
  found.rms = fit.rms * z * d;  // an error of z, z² that of 1/z, seen along the normal: times n·r = d/z
  for (const double entry : found.covariance) {
    if (!(entry - entry == 0)) return Status::invalid_option;
  }
  if (!(found.weight - found.weight == 0)) return Status::invalid_option;
  plane = found;
  return Status::ok;
}

InverseDepthPlane to_inverse_depth(const Plane& plane, const PinholeCamera& camera) noexcept {
  if (!(plane.distance > 0)) return {};
  const Vector3 m = (1 / plane.distance) * plane.normal;
  const double a = m.x / camera.fx;
  const double b = m.y / camera.fy;
  return {a, b, m.z - a * camera.cx - b * camera.cy};
}

Status inverse_depth_image(const DepthView& depth, ImageView<float> out,
                           const DepthKernels& kernels) noexcept {
  if (!depth.valid() || !out.valid()) return Status::invalid_image;
  if (out.size() != depth.raw.size()) return Status::size_mismatch;
  const double units_per_metre = 1 / depth.metres_per_unit;
  // Every quotient is a float of full precision then.
  if (!(units_per_metre > 1e-30 && units_per_metre < 1e38)) return Status::invalid_option;
  const auto scale = static_cast<float>(units_per_metre);
  for (std::int32_t row = 0; row < depth.raw.height; ++row) {
    kernels.invert(depth.raw.row(row), depth.raw.width, scale, out.row(row));
  }
  return Status::ok;
}

}  // namespace straightedge
