// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/cells_of.hpp"

namespace straightedge::octree {
namespace {

/// The same operations in the same order as OctreeGrid::cell_of. A coordinate that is outside becomes -1 before it
/// becomes an integer: not every double has one.
void cells_of_axis(const float* coordinates, std::size_t count, double origin, double scale,
                   std::int32_t* cells) noexcept {
  constexpr double o = octree_origin_cell, end = morton_side;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(coordinates[i]) - origin) * scale + o;
    const double above = at >= 0 ? at : -1;
    cells[i] = static_cast<std::int32_t>(above < end ? above : -1);
  }
}

}  // namespace

void cells_of(const PointsView& view, const OctreeGrid& grid, std::size_t begin, std::size_t count,
              CellBatch& cells) noexcept {
  cells.x[0] = cells.x[CellBatch::size];
  cells.y[0] = cells.y[CellBatch::size];
  cells.z[0] = cells.z[CellBatch::size];
  const double scale = 1 / grid.leaf_m;
  const Vector3& origin = grid.origin;
  if (view.stride == static_cast<std::ptrdiff_t>(sizeof(float))) {
    cells_of_axis(view.x + begin, count, origin.x, scale, cells.x + 1);
    cells_of_axis(view.y + begin, count, origin.y, scale, cells.y + 1);
    cells_of_axis(view.z + begin, count, origin.z, scale, cells.z + 1);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    MortonCell cell;
    const bool inside = grid.cell_of(view.at(begin + i), cell);
    cells.x[i + 1] = inside ? static_cast<std::int32_t>(cell.x) : -1;
    cells.y[i + 1] = inside ? static_cast<std::int32_t>(cell.y) : -1;
    cells.z[i + 1] = inside ? static_cast<std::int32_t>(cell.z) : -1;
  }
}

}  // namespace straightedge::octree
