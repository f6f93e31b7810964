// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_patches.hpp"

namespace straightedge {

/// One infinite plane.
struct PlaneGroup {
  std::vector<std::uint32_t> patches;  ///< ascending
  Surface surface;
  SurfaceEstimate estimate;
};

/// Step 5 of the builder.
///
/// (a) The heaviest patch without a plane begins one. The plane takes the patches that agree with it, near
///     ones first: as it grows, its tilt becomes known well enough to judge those farther away.
/// (b) Planes that agree as wholes become one.
/// (c) Each patch goes to the plane that it misses least; planes are summed anew. Again with (b), a few
///     times or until nothing changes.
/// (d) Copies of one surface become one plane (plane_copies.hpp).
std::vector<PlaneGroup> group_patches(std::span<const PlanePatch> patches, std::span<const PlaneLeaf> leaves,
                                      const PlaneMapOptions& options);

/// `whole` takes the patches of `part`, which is empty then, and is summed anew.
void absorb(PlaneGroup& whole, PlaneGroup& part, std::span<const PlanePatch> patches,
            const PlaneMapOptions& options);

/// Without the empty ones.
void heaviest_first(std::vector<PlaneGroup>& groups);

}  // namespace straightedge
