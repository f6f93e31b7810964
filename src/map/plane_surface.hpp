// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "straightedge/host/plane_leaves.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/plane_fit.hpp"

namespace straightedge {

/// Sums over leaves in metres: what the leaves' integers mean. A leaf, a patch and a whole plane are all
/// surfaces.
struct Surface {
  Vector3 origin;          ///< world; the moments count from here
  PlaneMoments moments;    ///< weights 1/m²; count: readings
  Vector3 towards_camera;  ///< sum of w · normal; of a plane of several patches, turned to one side
  double tilt = 0;         ///< sum of w · variance of the normal
  double residual = 0;     ///< sum of w · squared distance from the frame's plane
  double seen_front = 0, seen_back = 0;  ///< weights of what was seen from the normal's side and from behind
  std::uint64_t sightings = 0;

  /// Adds another one, turned if need be so that both normals point to one side.
  void add(const Surface& other);
};

/// Scatter about the centroid, xx xy xz yy yz zz, and what of it lies along a direction.
inline std::array<double, 6> scatter_of(const PlaneMoments& m) {
  const double by_weight = 1 / m.weight;
  return {m.xx - m.x * m.x * by_weight, m.xy - m.x * m.y * by_weight, m.xz - m.x * m.z * by_weight,
          m.yy - m.y * m.y * by_weight, m.yz - m.y * m.z * by_weight, m.zz - m.z * m.z * by_weight};
}
inline double quadratic(const std::array<double, 6>& s, const Vector3& t) {
  return s[0] * t.x * t.x + s[3] * t.y * t.y + s[5] * t.z * t.z +
         2 * (s[1] * t.x * t.y + s[2] * t.x * t.z + s[4] * t.y * t.z);
}

inline double bilinear(const std::array<double, 6>& s, const Vector3& t, const Vector3& r) {
  return s[0] * t.x * r.x + s[3] * t.y * r.y + s[5] * t.z * r.z + s[1] * (t.x * r.y + t.y * r.x) +
         s[2] * (t.x * r.z + t.z * r.x) + s[4] * (t.y * r.z + t.z * r.y);
}

/// The sums of one leaf, counted from `origin`.
Surface surface_of(const PlaneLeaf& leaf, const Vector3& origin);

/// Where a surface is and how well that is known. Errors of the two tilts and of the offset at the centroid
/// are independent.
struct SurfaceEstimate {
  Vector3 centroid, normal;
  Vector3 u, v;  ///< with the normal an orthonormal basis, right-handed
  double var_u = 0, var_v = 0, var_offset = 0;
};

/// The normal comes from the sums over places or from the mean of the frame planes' normals, whichever is
/// known better: the latter for small pieces of well-seen walls.
SurfaceEstimate estimate(const Surface& surface, const PlaneMapOptions& options);

/// The plane that fits the sums best, with its residual and the covariance of readings that share noise.
PlaneFit fitted(const Surface& surface, const PlaneMapOptions& options);

/// Whether a piece may be of a plane, and by how much it misses it.
struct Agreement {
  bool possible = false;
  double miss = 0;  ///< metres²; a tilt counts as it shows 0.3 m from the centroid
};
Agreement agree(const SurfaceEstimate& plane, const SurfaceEstimate& piece, const PlaneMapOptions& options);

}  // namespace straightedge
