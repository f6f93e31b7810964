// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_votes.hpp"

#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::hough {
namespace {

constexpr double reach = 2.449489742783178;  // the root of vote_reach_squared

Vector3 aside(const Vector3& n) noexcept {
  const double x = n.x * n.x, y = n.y * n.y, z = n.z * n.z;
  if (x <= y && x <= z) return {1, 0, 0};
  return y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
}

/// A symmetric 2x2 matrix.
struct Symmetric {
  double uu = 0, uv = 0, vv = 0;
  double determinant() const noexcept { return uu * vv - uv * uv; }
  Symmetric inverse() const noexcept {
    const double d = determinant();
    return {vv / d, -uv / d, uu / d};
  }
  double largest_eigenvalue() const noexcept {
    const double half = (uu - vv) / 2;
    return (uu + vv) / 2 + square_root(half * half + uv * uv);
  }
};

/// What the normal's turns along the tangents do to the slopes a and b, the mean reading held.
struct Slopes {
  double a = 0, b = 0;
};

Slopes slopes_by(const HoughPatch& patch, const Vector3& tangent, const PinholeCamera& camera) noexcept {
  const double per_d = 1 / patch.space.distance;
  const double lever = dot(tangent, patch.point) * per_d;
  const Vector3 dm = per_d * (tangent - lever * patch.space.normal);
  return {dm.x / camera.fx, dm.y / camera.fy};
}

}  // namespace

void shape_vote(const PatchScene& scene, HoughPatch& patch) noexcept {
  const PinholeCamera& camera = scene.camera;
  patch.space = scene.space(patch.plane);
  if (!(patch.space.distance > 0)) return;
  patch.point = (1 / patch.mean_q) * camera.ray(patch.mean_u, patch.mean_v);
  patch.tangent_u = normalized(cross(aside(patch.space.normal), patch.space.normal));
  patch.tangent_v = cross(patch.space.normal, patch.tangent_u);
  const Slopes u = slopes_by(patch, patch.tangent_u, camera);
  const Slopes v = slopes_by(patch, patch.tangent_v, camera);
  const auto& [aa, ab, bb] = patch.slope_covariance;
  const Symmetric known = Symmetric{aa, ab, bb}.inverse();
  const auto product = [&](const Slopes& p, const Slopes& q) noexcept {
    return p.a * (known.uu * q.a + known.uv * q.b) + p.b * (known.uv * q.a + known.vv * q.b);
  };
  const Symmetric information{product(u, u), product(u, v), product(v, v)};
  if (!(information.determinant() > 0)) return;
  Symmetric covariance = information.inverse();
  const double limit = scene.options.max_spread_rad;
  const double largest = covariance.largest_eigenvalue();
  patch.votes = largest <= limit * limit;
  // So wide that no vote falls between the centres of cells.
  const double least = 0.6 * scene.cell_size_rad;
  covariance.uu += least * least;
  covariance.vv += least * least;
  const Symmetric p = covariance.inverse();
  patch.precision = {p.uu, p.uv, p.vv};
  patch.reach_rad = reach * square_root(covariance.largest_eigenvalue());
  if (patch.reach_rad > 1.5) patch.reach_rad = 1.5;
}

void cast_vote(const HoughPatch& patch, HoughAccumulator& accumulator) noexcept {
  const HoughDirections& directions = accumulator.directions();
  const auto& [uu, uv, vv] = patch.precision;
  // The kernel's integral over the tangent plane is 2 pi sqrt(det of the covariance), a cell's area 4 pi by
  // their number.
  const double share = 2 * square_root(uu * vv - uv * uv) / directions.size();
  const double scale = hough_patch_vote * readings_of(patch) * share;
  directions.for_near(patch.space.normal, patch.reach_rad, [&](std::int32_t cell) noexcept {
    const Vector3& n = directions.centre(cell);
    const double rest = 1 - kernel_distance(patch, n) * (1 / vote_reach_squared);
    if (!(rest > 0)) return;
    accumulator.vote(cell, dot(n, patch.point), static_cast<std::uint32_t>(scale * rest * rest));
  });
}

}  // namespace straightedge::hough
