// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/run_starts.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void find_run_starts(const OctreeCellBatch& cells, std::size_t points, OctreeRunStarts& starts) noexcept {
  constexpr std::size_t size = OctreeCellBatch::size;
  std::uint32_t is_start[size];
  for (std::size_t i = 0; i < size; ++i) {
    const std::int32_t changed =
        (cells.x[i] ^ cells.x[i + 1]) | (cells.y[i] ^ cells.y[i + 1]) | (cells.z[i] ^ cells.z[i + 1]);
    is_start[i] = changed != 0 ? 1 : 0;
  }
  // Without branches: where runs end is anybody's guess.
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < points; ++i) {
    starts.at[count] = static_cast<std::uint32_t>(i);
    count += is_start[i];
  }
  starts.count = count;
  StartCells found;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = starts.at[k] + std::size_t{1};
    found.x[k] = static_cast<std::uint32_t>(cells.x[i]);
    found.y[k] = static_cast<std::uint32_t>(cells.y[i]);
    found.z[k] = static_cast<std::uint32_t>(cells.z[i]);
  }
  note_parts(found, starts);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
