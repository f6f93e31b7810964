// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/cells_of.hpp"

namespace straightedge::octree {
namespace {

/// The same operations in the same order as OctreeGrid::cell_of. A coordinate that is outside becomes -1
/// before it becomes an integer: not every double has one.
void cells_of_axis(const float* coordinates, std::size_t count, double origin, double scale,
                   std::int32_t* cells) noexcept {
  constexpr double o = octree_origin_cell, end = morton_side;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(coordinates[i]) - origin) * scale + o;
    const double above = at >= 0 ? at : -1;
    cells[i] = static_cast<std::int32_t>(above < end ? above : -1);
  }
}

/// The coordinates side by side, where they are or in `room`.
const float* side_by_side(const float* axis, std::ptrdiff_t stride, std::size_t begin, std::size_t count,
                          float* room) noexcept {
  if (stride == static_cast<std::ptrdiff_t>(sizeof(float))) return axis + begin;
  const auto* from =
      reinterpret_cast<const unsigned char*>(axis) + static_cast<std::ptrdiff_t>(begin) * stride;
  for (std::size_t i = 0; i < count; ++i, from += stride) room[i] = *reinterpret_cast<const float*>(from);
  return room;
}

}  // namespace

void cells_of(const PointsView& view, const OctreeGrid& grid, std::size_t begin, std::size_t count,
              CellBatch& cells) noexcept {
  cells.x[0] = cells.x[CellBatch::size];
  cells.y[0] = cells.y[CellBatch::size];
  cells.z[0] = cells.z[CellBatch::size];
  const double scale = 1 / grid.leaf_m;
  float room[CellBatch::size];
  const auto axis = [&](const float* from, double origin, std::int32_t* to) {
    cells_of_axis(side_by_side(from, view.stride, begin, count, room), count, origin, scale, to + 1);
  };
  axis(view.x, grid.origin.x, cells.x);
  axis(view.y, grid.origin.y, cells.y);
  axis(view.z, grid.origin.z, cells.z);
}

}  // namespace straightedge::octree
