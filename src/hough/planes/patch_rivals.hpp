// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "hough/planes/patch_cells.hpp"
#include "hough/planes/patch_tree.hpp"
#include "straightedge/frame_planes_search.hpp"

namespace straightedge::hough {

/// Step 7 of hough_plane_patches.hpp: takes out candidates that others explain, those with few readings
/// first. Returns how many are left; they keep their order. Patches name candidates as they were counted
/// before. `contests`: room for one a candidate.
std::uint32_t drop_explained(const PatchScene& scene, const DepthInput& input,
                             std::span<const HoughPatch> patches, std::span<ProposedPlane> candidates,
                             std::span<detail::HoughContest> contests) noexcept;

}  // namespace straightedge::hough
