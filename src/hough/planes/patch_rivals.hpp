// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "hough/planes/patch_cells.hpp"
#include "hough/planes/patch_tree.hpp"

namespace straightedge::hough {

/// Are the readings of candidate `number`'s patches explained as well by the planes of the others that have more
/// readings, each reading by the nearest of them? So it is along a crease, where patches that lie half on one
/// wall and half on another look like a chamfer. `pixels` 0 marks candidates that are gone.
bool explained_by_rivals(const PatchScene& scene, const DepthInput& input, std::span<const HoughPatch> patches,
                         std::span<const HoughPlaneCandidate> candidates, std::uint32_t number) noexcept;

}  // namespace straightedge::hough
