// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/plane_fit.hpp"

namespace straightedge::detail {

/// Gives the fit this normal, and tangents that differ as little as possible from those it has.
inline void set_normal(PlaneFit& fit, const Vector3& normal) noexcept {
  fit.plane.normal = normal;
  fit.tangent_u = normalized(fit.tangent_u - dot(fit.tangent_u, normal) * normal);
  fit.tangent_v = cross(normal, fit.tangent_u);
}

/// Gives the plane the sign of canonical(). A turned normal turns tangent_v, so that the basis stays
/// right-handed; errors (xi_u, xi_v, d) become (−xi_u, xi_v, −d).
inline void make_canonical(PlaneFit& fit) noexcept {
  const Plane plane = canonical(fit.plane);
  if (dot(plane.normal, fit.plane.normal) < 0) {
    fit.tangent_v = -fit.tangent_v;
    fit.covariance[1] = -fit.covariance[1];
    fit.covariance[4] = -fit.covariance[4];
  }
  fit.plane = plane;
}

}  // namespace straightedge::detail
