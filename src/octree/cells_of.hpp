// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/octree_grid.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::octree {

/// Cells of points that follow one another, an axis at a time, so that processors take several points at once.
struct CellBatch {
  static constexpr std::size_t size = 128;

  std::int32_t x[size], y[size], z[size];  ///< an axis on which a point is outside the cube or not a number: -1

  bool outside(std::size_t i) const noexcept { return (x[i] | y[i] | z[i]) < 0; }
  MortonCell at(std::size_t i) const noexcept {
    return {static_cast<std::uint32_t>(x[i]), static_cast<std::uint32_t>(y[i]),
            static_cast<std::uint32_t>(z[i])};
  }
};

/// Equation (1) of octree_grid.hpp for points `begin` to `begin + count`, at most a batch.
void cells_of(const PointsView& view, const OctreeGrid& grid, std::size_t begin, std::size_t count,
              CellBatch& cells) noexcept;

}  // namespace straightedge::octree
