// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_memory.hpp"

namespace straightedge::hough {

/// Calls `work` with the first cell of the accumulator, whatever its type.
template <class Work>
auto with_cells(const HoughMemory& memory, Work work) noexcept {
  if (!memory.cells8.empty()) return work(memory.cells8.data());
  return memory.cells16.empty() ? work(memory.cells.data()) : work(memory.cells16.data());
}

inline void clear_cells(const HoughMemory& memory) noexcept {
  for (std::uint8_t& cell : memory.cells8) cell = 0;
  for (std::int16_t& cell : memory.cells16) cell = 0;
  for (std::int32_t& cell : memory.cells) cell = 0;
}

}  // namespace straightedge::hough
