// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "straightedge/plane.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// Weighted sums over points in space, all that a plane fit needs; sums of two sets add up to the sums of
/// both. Coordinates are relative to an origin that the caller keeps in mind: choose it near the points.
struct PlaneMoments {
  double weight = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  double count = 0;  ///< points, whatever their weight

  constexpr void add(const Vector3& p, double w = 1) noexcept {
    weight += w;
    x += w * p.x;
    y += w * p.y;
    z += w * p.z;
    xx += w * p.x * p.x;
    xy += w * p.x * p.y;
    xz += w * p.x * p.z;
    yy += w * p.y * p.y;
    yz += w * p.y * p.z;
    zz += w * p.z * p.z;
    count += 1;
  }
  constexpr void add(const PlaneMoments& o) noexcept {
    weight += o.weight;
    x += o.x;
    y += o.y;
    z += o.z;
    xx += o.xx;
    xy += o.xy;
    xz += o.xz;
    yy += o.yy;
    yz += o.yz;
    zz += o.zz;
    count += o.count;
  }
  /// The same points seen from an origin that lies at `o` of the present one.
  constexpr PlaneMoments seen_from(const Vector3& o) const noexcept {
    PlaneMoments m = *this;
    m.x = x - weight * o.x;
    m.y = y - weight * o.y;
    m.z = z - weight * o.z;
    m.xx = xx - 2 * o.x * x + weight * o.x * o.x;
    m.xy = xy - o.x * y - o.y * x + weight * o.x * o.y;
    m.xz = xz - o.x * z - o.z * x + weight * o.x * o.z;
    m.yy = yy - 2 * o.y * y + weight * o.y * o.y;
    m.yz = yz - o.y * z - o.z * y + weight * o.y * o.z;
    m.zz = zz - 2 * o.z * z + weight * o.z * o.z;
    return m;
  }
};

/// A plane with its uncertainty: errors of the normal along two tangents and of the distance.
struct PlaneFit {
  Plane plane;
  Vector3 tangent_u{1, 0, 0};  ///< with tangent_v and the normal a right-handed orthonormal basis
  Vector3 tangent_v{0, 1, 0};
  Vector3 centroid;
  /// Upper triangle, row by row, of the 3x3 covariance of (xi_u, xi_v, distance): the true normal is the
  /// given one + xi_u tangent_u + xi_v tangent_v (radians), the distance in metres.
  std::array<double, 6> covariance{};
  double weight = 0;  ///< sum of the weights
  double count = 0;   ///< points
  double rms = 0;     ///< root mean square distance of the points from the plane, weighted, metres
};

/// Errors that no number of points averages away (calibration, depth distortion, poses): common to all
/// points of a plane.
struct PlaneFloor {
  double angle_rad = 0.3 * 3.141592653589793 / 180;  ///< standard deviation of each tangent error
  double offset_m = 0.005;                           ///< standard deviation of the distance at the centroid
};

/// Weighted total least squares.
///
/// 1. Centroid m = sum(w p) / sum(w).
/// 2. Scatter about it, a symmetric 3x3 matrix.
/// 3. Its eigenvectors by Jacobi rotations (symmetric_eigen.hpp); the normal is that of the least.
/// 4. Covariance, for weights 1/sigma² of each point along the normal, eigenvalues l1 <= l2 <= l3:
///    var xi_u = 1/(l2 − l1), var xi_v = 1/(l3 − l1), var of the offset at the centroid 1/sum(w), carried
///    to the distance from the origin.
///
/// K. Pathak, N. Vaskevicius, A. Birk, "Uncertainty analysis for optimum plane extraction from noisy 3D
/// range-sensor point-clouds", Intelligent Service Robotics 3(1), 2010, doi:10.1007/s11370-009-0057-4.
///
/// The covariance is right for noise along the normal, or the same in all directions. Noise along rays
/// that meet the plane obliquely tilts step 2 as a slope would: depth frames are for inverse_depth.hpp.
///
/// invalid_option: fewer than three points, all on one line, spread alike in two least directions (no plane
/// fits better than another), or sums that are not numbers. `fit` is left alone then.
Status fit_plane(const PlaneMoments& moments, PlaneFit& fit) noexcept;

/// Adds the floor to the covariance.
void add_floor(PlaneFit& fit, const PlaneFloor& floor) noexcept;

/// Chi-square distance (3 degrees of freedom) between two planes that may be the same one: 7.81 is exceeded
/// by one true pair in twenty, 11.34 by one in a hundred. The test is made midway between the two
/// centroids, in the tangents of `a`; normals may point to opposite sides. A singular sum of covariances, or
/// one that is no covariance, gives infinity unless the planes are equal.
double plane_chi_square(const PlaneFit& a, const PlaneFit& b) noexcept;

/// Both planes' information together, where the points' sums are not at hand; exact for small angles. The
/// centroid is the mean by weight. invalid_option: a covariance that is not positive definite.
Status fuse_planes(const PlaneFit& a, const PlaneFit& b, PlaneFit& fused) noexcept;

/// The covariance of (nx, ny, nz, d) without a basis: upper triangle of the 4x4 matrix (rank 3), row by
/// row, as map files hold it.
std::array<double, 10> covariance_4x4(const PlaneFit& fit) noexcept;

/// The same plane with its uncertainty in another frame: x' = R x + t, `rotation` row by row.
PlaneFit moved(const PlaneFit& fit, const std::array<double, 9>& rotation, const Vector3& t) noexcept;

}  // namespace straightedge
