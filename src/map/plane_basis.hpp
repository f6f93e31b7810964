// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/vector3.hpp"

namespace straightedge {

/// Axes on a plane; with the normal right-handed.
struct PlaneBasis {
  Vector3 u, v;
};

/// Always the same for one normal: u is level for walls, and along the world's x for floors.
inline PlaneBasis plane_basis(const Vector3& n) noexcept {
  const auto size = [](double c) { return c < 0 ? -c : c; };
  const bool level = size(n.z) >= size(n.x) && size(n.z) >= size(n.y);
  const Vector3 u = normalized(cross(level ? Vector3{0, 1, 0} : Vector3{0, 0, 1}, n));
  return {u, cross(n, u)};
}

}  // namespace straightedge
