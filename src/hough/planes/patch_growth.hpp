// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "hough/planes/patch_tree.hpp"
#include "straightedge/frame_planes_search.hpp"

namespace straightedge::hough {

/// All patches, and the means of those that no candidate has taken: small, since every growth looks at all.
struct PatchPool {
  std::span<HoughPatch> patches;
  std::span<HoughPatchMean> free;

  HoughPatch& of(const HoughPatchMean& mean) const noexcept { return patches[mean.patch]; }
};

/// The pool of all patches; `means` has room for them.
PatchPool make_pool(std::span<HoughPatch> patches, std::span<HoughPatchMean> means) noexcept;

/// Step 5 of hough_plane_patches.hpp, from a peak to a plane. `number` is written into the patches that it
/// takes; they leave the pool. False: no free patch is near the peak, or the plane has fewer readings than a
/// candidate needs; the seed will not be tried again.
bool grow(const PatchScene& scene, const Plane& peak, PatchPool& pool, std::uint16_t number,
          ProposedPlane& candidate) noexcept;

}  // namespace straightedge::hough
