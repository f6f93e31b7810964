// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/vector3.hpp"

namespace straightedge {

/// normal · x = distance, |normal| = 1, distance >= 0 (distance 0: the first coordinate of the normal that
/// is not zero is positive). Metres. In a camera's or sensor's own frame the normal so points away
/// from the sensor.
struct Plane {
  Vector3 normal{0, 0, 1};
  double distance = 0;

  /// Metres; positive on the side to which the normal points.
  constexpr double signed_distance(const Vector3& p) const noexcept { return dot(normal, p) - distance; }
  constexpr bool operator==(const Plane&) const noexcept = default;
};

/// The same plane with the sign that the rule above asks for. The normal must have unit length.
constexpr Plane canonical(const Plane& plane) noexcept {
  const Vector3& n = plane.normal;
  const bool turned = plane.distance < 0 ||
                      (plane.distance == 0 && (n.x < 0 || (n.x == 0 && (n.y < 0 || (n.y == 0 && n.z < 0)))));
  if (!turned) return {n, plane.distance == 0 ? 0.0 : plane.distance};
  return {-n, plane.distance == 0 ? 0.0 : -plane.distance};
}

}  // namespace straightedge
