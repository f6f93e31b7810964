// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <cmath>

#include "straightedge/plane_fit.hpp"

/// Figures of merit, computed with Eigen and apart from the library.
namespace support {

inline Eigen::Vector3d eigen(const straightedge::Vector3& v) {
  return {v.x, v.y, v.z};
}

inline Eigen::Matrix3d covariance_of(const straightedge::PlaneFit& fit) {
  const auto& c = fit.covariance;
  Eigen::Matrix3d m;
  m << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return m;
}

/// The 4x4 covariance of (nx, ny, nz, d), from the basis.
inline Eigen::Matrix4d covariance_4x4_of(const straightedge::PlaneFit& fit) {
  Eigen::Matrix<double, 4, 3> basis = Eigen::Matrix<double, 4, 3>::Zero();
  basis.block<3, 1>(0, 0) = eigen(fit.tangent_u);
  basis.block<3, 1>(0, 1) = eigen(fit.tangent_v);
  basis(3, 2) = 1;
  return basis * covariance_of(fit) * basis.transpose();
}

/// Errors of a fit in its own tangents, and of its distance.
inline Eigen::Vector3d error_of(const straightedge::PlaneFit& fit, const straightedge::Plane& truth) {
  const double side = dot(fit.plane.normal, truth.normal) < 0 ? -1 : 1;
  return {side * dot(fit.tangent_u, truth.normal), side * dot(fit.tangent_v, truth.normal),
          side * truth.distance - fit.plane.distance};
}

/// Normalised estimation error squared; 3 on average when the covariance is honest.
inline double nees(const straightedge::PlaneFit& fit, const straightedge::Plane& truth) {
  const Eigen::Vector3d error = error_of(fit, truth);
  return error.dot(covariance_of(fit).ldlt().solve(error));
}

inline double angle_between(const straightedge::Vector3& a, const straightedge::Vector3& b) {
  return std::atan2(length(cross(a, b)), std::fabs(dot(a, b)));
}

}  // namespace support
