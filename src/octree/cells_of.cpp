// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/cells_of.hpp"

namespace straightedge::octree {
namespace {

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
              const OctreeKernels& kernels, OctreeCellBatch& cells) noexcept {
  cells.x[0] = cells.x[OctreeCellBatch::size];
  cells.y[0] = cells.y[OctreeCellBatch::size];
  cells.z[0] = cells.z[OctreeCellBatch::size];
  const double scale = 1 / grid.leaf_m;
  float room[OctreeCellBatch::size];
  const auto axis = [&](const float* from, double origin, std::int32_t* to) {
    kernels.cells(side_by_side(from, view.stride, begin, count, room), count,
                  {origin, scale, octree_origin_cell, morton_side}, to + 1);
  };
  axis(view.x, grid.origin.x, cells.x);
  axis(view.y, grid.origin.y, cells.y);
  axis(view.z, grid.origin.z, cells.z);
}

}  // namespace straightedge::octree
