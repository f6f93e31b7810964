// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "map/plane_row_bits.hpp"

// The same results as plane_label_changes.hpp; read that first. AVX2, 32 labels at a time.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

inline void label_changes(const std::uint16_t* labels, std::int32_t count, std::uint64_t* changes) noexcept {
  for (std::int32_t w = 0; w < count / 64 + 2; ++w) changes[w] = 0;
  const auto same = [labels](std::int32_t n) {
    const auto load = [](const std::uint16_t* at) {
      return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
    };
    return _mm256_cmpeq_epi16(load(labels + n), load(labels + n - 1));
  };
  std::int32_t n = 1;
  for (; n + 32 <= count; n += 32) {
    const __m256i quarters = _mm256_packs_epi16(same(n), same(n + 16));
    const __m256i in_order = _mm256_permute4x64_epi64(quarters, _MM_SHUFFLE(3, 1, 2, 0));
    set_bits(changes, n, ~static_cast<std::uint32_t>(_mm256_movemask_epi8(in_order)));
  }
  for (; n < count; ++n) set_bits(changes, n, labels[n] != labels[n - 1] ? 1 : 0);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
