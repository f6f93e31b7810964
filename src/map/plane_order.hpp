// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "straightedge/host/plane_map.hpp"

namespace straightedge {

/// The order of a map's planes: most readings first, then by normal and distance.
inline bool comes_first(const MapPlane& a, const MapPlane& b) {
  const std::uint64_t a_points = a.points.value_or(0), b_points = b.points.value_or(0);
  if (a_points != b_points) return a_points > b_points;
  const Vector3& n = a.plane.normal;
  const Vector3& m = b.plane.normal;
  if (n.x != m.x) return n.x < m.x;
  if (n.y != m.y) return n.y < m.y;
  if (n.z != m.z) return n.z < m.z;
  return a.plane.distance < b.plane.distance;
}

}  // namespace straightedge
