// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_surface.hpp"

namespace straightedge {

/// The surfaces of neighbouring leaves that agree.
struct PlanePatch {
  Surface surface;
  SurfaceEstimate estimate;
  std::vector<std::uint32_t> leaves;  ///< indices into the sorted leaves
};

/// Step 4 of the builder. Leaves of one block of 8x8x8 (1 m) are taken heaviest first; each joins the
/// patch of its block that it misses least, or begins one. `leaves` are sorted by key, so a block is a run of
/// them. The heaviest patch comes first, equals in the order of their leaves.
std::vector<PlanePatch> make_patches(std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options);

}  // namespace straightedge
