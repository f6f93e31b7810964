// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/plane_row.hpp"
#include "straightedge/detail/plane_run.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Which leaf holds the place at quanta i, j, k.
inline std::uint64_t run_leaf(std::int32_t i, std::int32_t j, std::int32_t k) noexcept {
  const auto cell = [](std::int32_t quanta) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(quanta) >> plane_row::leaf_bits);
  };
  return cell(i) | (cell(j) << 21U) | (cell(k) << 42U);
}

inline std::uint32_t run_slot(std::uint64_t leaf, std::uint32_t label, std::uint32_t shift) noexcept {
  // Multiplication carries every bit upwards; the upper bits choose the slot.
  const std::uint64_t mixed = (leaf + label * 0xD1B54A32D192ED03U) * 0x9E3779B97F4A7C15U;
  return static_cast<std::uint32_t>(mixed >> shift);
}

/// The run of this plane and leaf with room for `more` readings, a new one if need be. The table must have
/// room for one more run.
inline detail::PlaneRun& run_for(detail::PlaneRunTable& table, std::uint64_t leaf, std::uint32_t label,
                                 std::int32_t more) noexcept {
  const std::uint32_t last = 0xFFFFFFFFU >> (table.shift - 32);
  std::uint32_t slot = run_slot(leaf, label, table.shift);
  for (; table.slots[slot] != 0; slot = (slot + 1) & last) {
    detail::PlaneRun& run = table.runs[table.slots[slot] - 1];
    if (run.leaf != leaf || run.label != label) continue;
    if (run.readings + more <= detail::PlaneRun::most_readings) return run;
    break;  // a full one is left behind, and the new one takes its slot
  }
  detail::PlaneRun& run = table.runs[table.used];
  table.slots[slot] = ++table.used;
  run = {};
  run.leaf = leaf;
  run.label = label;
  return run;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
