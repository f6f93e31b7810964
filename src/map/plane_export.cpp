// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_export.hpp"

#include <algorithm>
#include <limits>

namespace straightedge {
namespace {

// A share of the readings that is not a matter of chance or of a wrong label.
constexpr double clearly = 0.02;

SeenSide seen_side(const Surface& s, bool normal_turned) {
  const double all = s.seen_front + s.seen_back;
  bool plus = s.seen_front > clearly * all;
  bool minus = s.seen_back > clearly * all;
  if (normal_turned) std::swap(plus, minus);
  if (plus && minus) return SeenSide::both;
  return plus ? SeenSide::plus : SeenSide::minus;
}

/// The scatter about the mean, with what the readings missed their frames' planes by.
std::array<double, 6> honest_scatter(const Surface& s, const Vector3& n) {
  const PlaneMoments& m = s.moments;
  const double w = 1 / m.weight;
  return {m.xx - m.x * m.x * w + s.residual * n.x * n.x, m.xy - m.x * m.y * w + s.residual * n.x * n.y,
          m.xz - m.x * m.z * w + s.residual * n.x * n.z, m.yy - m.y * m.y * w + s.residual * n.y * n.y,
          m.yz - m.y * m.z * w + s.residual * n.y * n.z, m.zz - m.z * m.z * w + s.residual * n.z * n.z};
}

}  // namespace

MapPlane exported(const PlaneGroup& group, const PlaneMapOptions& options) {
  const Surface& s = group.surface;
  const PlaneFit fit = fitted(s, options);
  MapPlane plane;
  plane.plane = fit.plane;
  plane.points = static_cast<std::uint64_t>(s.moments.count);
  plane.count = static_cast<std::uint32_t>(
      std::min<std::uint64_t>(s.sightings, std::numeric_limits<std::uint32_t>::max()));
  plane.seen = seen_side(s, dot(s.towards_camera, fit.plane.normal) < 0);
  plane.covariance = covariance_4x4(fit);
  MapMoments moments;
  moments.weight = s.moments.weight;
  moments.mean = fit.centroid;
  moments.scatter = honest_scatter(s, fit.plane.normal);
  plane.moments = moments;
  return plane;
}

}  // namespace straightedge
