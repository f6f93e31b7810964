// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane.hpp"

namespace straightedge {

/// A square of the depth picture whose readings lie on one plane within their noise.
struct HoughPatch {
  std::int32_t x = 0, y = 0, side = 0;  ///< first column and row, pixels
  std::uint16_t candidate = 0;          ///< index + 1 of the candidate that has it, 0: none
  bool votes = false;                   ///< its direction is known well enough for a vote

  InverseDepthMoments moments;
  InverseDepthPlane plane;
  double mean_q = 0;                        ///< 1/metre
  double mean_u = 0, mean_v = 0;            ///< pixels
  double noise = 0;                         ///< variance of one independent reading's 1/z
  std::array<double, 3> slope_covariance{};  ///< of plane.a, plane.b: aa, ab, bb

  Vector3 point;                 ///< where the mean ray meets the plane, metres
  Plane space;                   ///< the plane in the camera's frame
  Vector3 tangent_u, tangent_v;  ///< unit vectors, orthogonal to its normal
  std::array<double, 3> precision{};  ///< inverse covariance of the normal's errors along the tangents,
                                      ///< enlarged by the cell size: uu, uv, vv
  double reach_rad = 0;          ///< directions farther from the normal get no vote
};

}  // namespace straightedge
