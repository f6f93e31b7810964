// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "hough/planes/patch_tree.hpp"

namespace straightedge::hough {

/// How well the patch knows its normal, as a kernel over directions; sets `votes`.
void shape_vote(const PatchScene& scene, HoughPatch& patch) noexcept;

/// Squared distance of a direction from the patch's normal in units of its kernel; above
/// vote_reach_squared there is no vote.
inline double kernel_distance(const HoughPatch& patch, const Vector3& direction) noexcept {
  if (!(dot(direction, patch.space.normal) > 0)) return 1e9;
  const double u = dot(direction, patch.tangent_u);
  const double v = dot(direction, patch.tangent_v);
  const auto& [uu, uv, vv] = patch.precision;
  return u * (uu * u + 2 * uv * v) + vv * v * v;
}
inline constexpr double vote_reach_squared = 6;

/// Step 3 of hough_plane_patches.hpp.
void cast_vote(const HoughPatch& patch, HoughAccumulator& accumulator) noexcept;

}  // namespace straightedge::hough
