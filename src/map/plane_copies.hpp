// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "map/plane_groups.hpp"

namespace straightedge {

/// Part (d) of step 5: copies of one surface become one plane.
///
/// Frames whose poses or depths are wrong by more than the floors show a wall beside itself. Two surfaces
/// cannot be seen from one side, one close behind the other, over the same area: the one in front hides the
/// other. So a plane whose leaves lie, for the greater part, where a heavier plane has leaves too, at most
/// copy_offset from it and copy_angle askew, seen from the same side, is a copy. A step in a wall is none:
/// its two parts lie side by side.
///
/// Groups come heaviest first and stay so. True when some were joined.
bool join_copies(std::vector<PlaneGroup>& groups, std::span<const PlanePatch> patches,
                 std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options);

}  // namespace straightedge
