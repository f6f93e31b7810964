// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "map/plane_row_bits.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Bit n is set where label n is another one than the label before it, but not for the first label. Writes
/// count / 64 + 2 words.
inline void label_changes(const std::uint16_t* labels, std::int32_t count, std::uint64_t* changes) noexcept {
  for (std::int32_t w = 0; w < count / 64 + 2; ++w) changes[w] = 0;
  std::int32_t n = 1;
  for (; n + 4 <= count; n += 4) {
    std::uint64_t now, before;
    __builtin_memcpy(&now, labels + n, sizeof now);
    __builtin_memcpy(&before, labels + n - 1, sizeof before);
    if (now == before) continue;
    for (std::int32_t i = n; i < n + 4; ++i) set_bits(changes, i, labels[i] != labels[i - 1] ? 1 : 0);
  }
  for (; n < count; ++n) set_bits(changes, n, labels[n] != labels[n - 1] ? 1 : 0);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
