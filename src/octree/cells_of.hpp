// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::octree {

/// Equation (1) of octree_grid.hpp for points `begin` to `begin + count`, a full batch but for the last.
void cells_of(const PointsView& view, const OctreeGrid& grid, std::size_t begin, std::size_t count,
              const OctreeKernels& kernels, OctreeCellBatch& cells) noexcept;

}  // namespace straightedge::octree
