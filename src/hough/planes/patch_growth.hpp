// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "hough/planes/patch_tree.hpp"

namespace straightedge::hough {

/// Step 5 of hough_plane_patches.hpp, from a peak to a plane. `number` is written into the patches that it
/// takes. False: no free patch is near the peak, or the plane has fewer readings than a candidate needs; the
/// seed will not be tried again.
bool grow(const PatchScene& scene, const Plane& peak, std::span<HoughPatch> patches, std::uint16_t number,
          HoughPlaneCandidate& candidate) noexcept;

}  // namespace straightedge::hough
