// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/kernel_set.hpp"
#include "straightedge/octree_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// What octree_kernels.hpp tells of it.
void find_run_starts(const OctreeCellBatch& cells, std::size_t points, OctreeRunStarts& starts) noexcept;

/// Cells at which runs start.
struct StartCells {
  std::uint32_t x[OctreeCellBatch::size], y[OctreeCellBatch::size], z[OctreeCellBatch::size];
};

/// Bit i to bit 3 i, of nine bits.
inline std::uint32_t spread_nine(std::uint32_t v) noexcept {
  v &= 0x1ff;
  v = (v | (v << 16U)) & 0x0300'00ff;
  v = (v | (v << 8U)) & 0x0300'f00f;
  v = (v | (v << 4U)) & 0x030c'30c3;
  return (v | (v << 2U)) & 0x0924'9249;
}
inline std::uint32_t part_of(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept {
  return spread_nine(x) | spread_nine(y) << 1U | spread_nine(z) << 2U;
}

/// All of `starts` but where they are.
inline void note_parts(const StartCells& cells, OctreeRunStarts& starts) noexcept {
  const std::uint32_t first_x = starts.first.x, first_y = starts.first.y, first_z = starts.first.z;
  const std::uint32_t first_part = part_of(first_x, first_y, first_z);
  std::uint32_t part_differs = 0, cell_differs = 0;
  for (std::size_t k = 0; k < starts.count; ++k) {
    const std::uint32_t x = cells.x[k], y = cells.y[k], z = cells.z[k];
    const std::uint32_t outside = (x | y | z) >> 31U, inside = outside - 1;
    const std::uint32_t part = part_of(x, y, z);
    starts.outside[k] = outside;
    starts.part[k] = part;
    part_differs |= (part ^ first_part) & inside;
    cell_differs |= ((x ^ first_x) | (y ^ first_y) | (z ^ first_z)) & inside;
  }
  starts.part_differs |= part_differs;
  starts.cell_differs |= cell_differs;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
