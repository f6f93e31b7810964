// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/lowest_bit.hpp"
#include "four_labels.hpp"
#include "straightedge/depth_kernels.hpp"

namespace straightedge::detail {

/// Bit i: cell i has no plane.
inline std::uint32_t bits_of_free(const std::uint16_t* labels, std::int32_t count) noexcept {
  std::uint32_t free = 0;
  std::int32_t i = 0;
  for (; i + 4 <= count; i += 4) free |= lowest_of(~not_zero(four(labels + i)) >> 15U) << i;
  for (; i < count; ++i) free |= static_cast<std::uint32_t>(labels[i] == 0) << i;
  return free;
}

/// Bit i: cell i is not decided.
inline std::uint32_t bits_of_undecided(const DepthCellPlanes& found) noexcept {
  static_assert(DepthCellPlanes::undecided >> 15U == 1, "no label has the top bit");
  std::uint32_t undecided = 0;
  for (std::int32_t i = 0; i < DepthCellTask::cells; i += 4)
    undecided |= lowest_of(four(found.label + i) >> 15U) << i;
  return undecided;
}

/// Calls visit(i) for each bit i.
template <class Visit>
void for_bits(std::uint32_t bits, const Visit& visit) noexcept {
  for (; bits != 0; bits &= bits - 1) visit(lowest_bit(bits));
}

/// Cells that no plane around fits, from all over a level: all planes are tried on sixteen at once.
struct Undecided {
  std::array<float, std::size_t{DepthCellRows::kinds} * DepthCellTask::cells> numbers{};
  std::array<std::uint16_t*, DepthCellTask::cells> label{};
  std::size_t count = 0;

  void add(const DepthCellRows& cell, std::uint16_t* its_label) noexcept {
    for (std::size_t kind = 0; kind < DepthCellRows::kinds; ++kind) {
      numbers[kind * DepthCellTask::cells + count] =
          cell.first[static_cast<std::ptrdiff_t>(kind) * cell.apart];
    }
    label[count++] = its_label;
  }
  bool is_full() const noexcept { return count == DepthCellTask::cells; }
};

}  // namespace straightedge::detail
