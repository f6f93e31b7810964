// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/octree_grid.hpp"

namespace straightedge::octree {

/// The Morton codes of points that come one after another. Neighbours in a scan, and in sorted order, mostly
/// share a cell, and then the code is at hand.
class CodeReader {
 public:
  explicit CodeReader(const OctreeGrid& grid) noexcept : grid_(grid) {}

  /// Of a point that is in the cube.
  std::uint64_t code_of(const Vector3& point) noexcept {
    MortonCell cell;
    if (grid_.cell_of(point, cell) && cell != cell_) {
      cell_ = cell;
      code_ = morton_encode(cell);
    }
    return code_;
  }
  /// In the cell of the last point asked about.
  bool same_cell(const Vector3& point) const noexcept {
    MortonCell cell;
    return grid_.cell_of(point, cell) && cell == cell_;
  }

 private:
  OctreeGrid grid_;
  MortonCell cell_;
  std::uint64_t code_ = 0;
};

}  // namespace straightedge::octree
