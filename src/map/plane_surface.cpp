// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_surface.hpp"

#include <algorithm>
#include <array>

#include "map/plane_basis.hpp"
#include "map/plane_key.hpp"
#include "straightedge/symmetric_eigen.hpp"

namespace straightedge {
namespace {

double number(std::int64_t sum) {
  return static_cast<double>(sum);
}

double square(double x) {
  return x * x;
}

/// Variance of a tilt that is read from places which spread by `spread` (weight · m²): noise, and the
/// offsets that whole frames have in common.
double tilt_by_places(double spread, double weight, const PlaneMapOptions& options) {
  if (!(spread > 0)) return 1;
  return std::min(1.0, options.shared_noise / spread + square(options.floor.offset_m) * weight / spread);
}

}  // namespace

void Surface::add(const Surface& other) {
  const bool turned = dot(towards_camera, other.towards_camera) < 0;
  moments.add(other.moments.seen_from(origin - other.origin));
  towards_camera = towards_camera + (turned ? -1.0 : 1.0) * other.towards_camera;
  tilt += other.tilt;
  residual += other.residual;
  seen_front += turned ? other.seen_back : other.seen_front;
  seen_back += turned ? other.seen_front : other.seen_back;
  sightings += other.sightings;
}

Surface surface_of(const PlaneLeaf& leaf, const Vector3& origin) {
  const PlaneLeafSums& s = leaf.sums;
  constexpr double w = plane_grid::weight_unit;
  constexpr double q = plane_grid::quantum_m;
  Surface surface;
  surface.origin = origin;
  PlaneMoments& m = surface.moments;
  m.weight = w * number(s.weight);
  m.x = w * q * number(s.x);
  m.y = w * q * number(s.y);
  m.z = w * q * number(s.z);
  m.xx = w * q * q * number(s.xx);
  m.xy = w * q * q * number(s.xy);
  m.xz = w * q * q * number(s.xz);
  m.yy = w * q * q * number(s.yy);
  m.yz = w * q * q * number(s.yz);
  m.zz = w * q * q * number(s.zz);
  m.count = static_cast<double>(s.readings);
  const Vector3 half_quantum{q / 2, q / 2, q / 2};
  m = m.seen_from(origin - leaf_centre(morton_decode(leaf.key.leaf)) - half_quantum);
  surface.towards_camera = (w * plane_grid::normal_unit) * Vector3{number(s.nx), number(s.ny), number(s.nz)};
  surface.tilt = w * plane_grid::tilt_unit * number(s.tilt);
  surface.residual = w * q * q * number(s.residual);
  surface.seen_front = m.weight;
  surface.sightings = s.sightings;
  return surface;
}

SurfaceEstimate estimate(const Surface& surface, const PlaneMapOptions& options) {
  const PlaneMoments& m = surface.moments;
  const std::array<double, 6> scatter = scatter_of(m);
  SurfaceEstimate e;
  e.centroid = surface.origin + (1 / m.weight) * Vector3{m.x, m.y, m.z};
  const double by_frames = options.shared_noise * surface.tilt / m.weight;
  e.normal = normalized(surface.towards_camera);
  const double bar = by_frames + square(options.floor.angle_rad);
  // The second largest spread is at most half of all: mostly that is too little already.
  const double most_spread = 0.51 * (scatter[0] + scatter[3] + scatter[5]);
  const bool by_places = tilt_by_places(most_spread, m.weight, options) < bar;
  const SymmetricEigen eigen = by_places ? symmetric_eigen(scatter) : SymmetricEigen{};
  if (by_places && tilt_by_places(eigen.values[1], m.weight, options) < bar) {
    e.normal = (dot(eigen.vectors[0], e.normal) < 0 ? -1.0 : 1.0) * eigen.vectors[0];
    e.u = eigen.vectors[1];
  } else {
    e.u = plane_basis(e.normal).u;
  }
  e.v = cross(e.normal, e.u);
  const double floor = square(options.floor.angle_rad);
  e.var_u = std::min(by_frames, tilt_by_places(quadratic(scatter, e.u), m.weight, options)) + floor;
  e.var_v = std::min(by_frames, tilt_by_places(quadratic(scatter, e.v), m.weight, options)) + floor;
  e.var_offset = options.shared_noise / m.weight + square(options.floor.offset_m) +
                 square(options.reading_floor) * m.count / m.weight;
  return e;
}

PlaneFit fitted(const Surface& surface, const PlaneMapOptions& options) {
  const SurfaceEstimate e = estimate(surface, options);
  PlaneFit local;
  const bool wide = fit_plane(surface.moments, local) == Status::ok;
  if (!wide || dot(local.plane.normal, e.normal) * dot(local.plane.normal, e.normal) < 0.9) {
    // Too narrow a strip to say its own tilt: the frames' planes say it.
    const Vector3 at = e.centroid - surface.origin;
    const bool behind = dot(e.normal, at) < 0;
    local.plane = canonical({e.normal, dot(e.normal, at)});
    local.tangent_u = behind ? -e.u : e.u;
    local.tangent_v = e.v;
    local.centroid = at;
  }
  local.tangent_v = cross(local.plane.normal, local.tangent_u);
  const double mu = dot(local.tangent_u, local.centroid);
  const double mv = dot(local.tangent_v, local.centroid);
  const std::array<double, 6> scatter = scatter_of(surface.moments);
  const double var_u =
      std::min(1.0, options.shared_noise / std::max(1e-12, quadratic(scatter, local.tangent_u)));
  const double var_v =
      std::min(1.0, options.shared_noise / std::max(1e-12, quadratic(scatter, local.tangent_v)));
  local.covariance = {
      var_u, 0,          mu * var_u,
      var_v, mv * var_v, options.shared_noise / surface.moments.weight + mu * mu * var_u + mv * mv * var_v};
  local.weight = surface.moments.weight;
  local.count = surface.moments.count;
  const double across_plane = std::max(0.0, quadratic(scatter, local.plane.normal)) + surface.residual;
  local.rms = __builtin_sqrt(across_plane / local.weight);
  add_floor(local, options.floor);
  return moved(local, {1, 0, 0, 0, 1, 0, 0, 0, 1}, surface.origin);
}

Agreement agree(const SurfaceEstimate& plane, const SurfaceEstimate& piece, const PlaneMapOptions& options) {
  const double facing = dot(plane.normal, piece.normal);
  const double side = facing < 0 ? -1 : 1;
  if (1 - facing * facing > square(options.max_angle)) return {};
  const Vector3 from = piece.centroid - plane.centroid;
  const double offset = dot(plane.normal, from);
  if (square(offset) > square(options.max_offset)) return {};
  const auto tilt = [&](const Vector3& t, double var) {
    const double error = side * dot(t, piece.normal);
    return square(error) /
           (var + piece.var_u * square(dot(t, piece.u)) + piece.var_v * square(dot(t, piece.v)));
  };
  const double var_offset = plane.var_offset + piece.var_offset + plane.var_u * square(dot(plane.u, from)) +
                            plane.var_v * square(dot(plane.v, from));
  const double chi_square =
      square(offset) / var_offset + tilt(plane.u, plane.var_u) + tilt(plane.v, plane.var_v);
  if (!(chi_square <= options.chi_square)) return {};
  return {true, square(offset) + square(0.3) * (1 - facing * facing)};
}

}  // namespace straightedge
