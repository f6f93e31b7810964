// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::octree {

/// Cells of points that follow one another, an axis at a time, so that processors take several points at
/// once.
struct CellBatch {
  static constexpr std::size_t size = 64;

  /// Element 0 is the last point of the batch before; an axis on which a point is outside the cube or not a
  /// number is -1, and so is every axis before the first point.
  std::int32_t x[size + 1], y[size + 1], z[size + 1];

  CellBatch() noexcept { x[size] = y[size] = z[size] = -1; }
  /// Of all points, -1 for those in another cell than the one before, 0 for the others.
  void find_starts(std::int32_t* starts) const noexcept;
  MortonCell at(std::size_t i) const noexcept {
    return {static_cast<std::uint32_t>(x[i + 1]), static_cast<std::uint32_t>(y[i + 1]),
            static_cast<std::uint32_t>(z[i + 1])};
  }
};

/// Equation (1) of octree_grid.hpp for points `begin` to `begin + count`, a full batch but for the last.
void cells_of(const PointsView& view, const OctreeGrid& grid, std::size_t begin, std::size_t count,
              const OctreeKernels& kernels, CellBatch& cells) noexcept;

}  // namespace straightedge::octree
