// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "straightedge/vector3.hpp"

namespace straightedge {

/// Where a camera stands: world_from_camera, x_world = rotation · x_camera + translation.
struct Pose {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< row by row; a rotation, no mirror
  Vector3 translation;                                        ///< metres

  constexpr Vector3 turned(const Vector3& d) const noexcept {
    const auto& r = rotation;
    return {r[0] * d.x + r[1] * d.y + r[2] * d.z, r[3] * d.x + r[4] * d.y + r[5] * d.z,
            r[6] * d.x + r[7] * d.y + r[8] * d.z};
  }
  constexpr Vector3 apply(const Vector3& p) const noexcept { return turned(p) + translation; }
  constexpr bool operator==(const Pose&) const noexcept = default;
};

}  // namespace straightedge
