// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../rename_row.cpp; read that first. Up to 64 names lie in registers, where many labels look
// theirs up at once.
#include <immintrin.h>

#include "fit/pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t most_names = 64;

#if defined(__AVX512BW__)
constexpr std::int32_t at_once = 32;

struct Names {
  __m512i low, high;

  Names(const std::uint16_t* by, std::int32_t names) noexcept
      : low(some(by, names)), high(some(by + (names > at_once ? at_once : 0), names - at_once)) {}
  void rename(std::uint16_t* labels) const noexcept {
    const __m512i before = _mm512_loadu_si512(labels);
    _mm512_storeu_si512(labels, _mm512_permutex2var_epi16(low, before, high));
  }

 private:
  static __m512i some(const std::uint16_t* by, std::int32_t count) noexcept {
    const std::uint32_t all = 0xFFFFFFFFU;
    const std::uint32_t there = count >= at_once ? all
                                : count > 0      ? (1U << static_cast<std::uint32_t>(count)) - 1U
                                                 : 0U;
    return _mm512_maskz_loadu_epi16(there, by);
  }
};
#else
constexpr std::int32_t at_once = 16, tables = most_names / 16;

/// Tables of sixteen bytes, since no name of so few needs more.
struct Names {
  __m256i of[tables];
  std::int32_t count;

  Names(const std::uint16_t* by, std::int32_t names) noexcept : count((names + 15) / 16) {
    alignas(16) std::uint8_t bytes[most_names] = {};
    for (std::int32_t k = 0; k < names; ++k) bytes[k] = static_cast<std::uint8_t>(by[k]);
    for (std::int32_t k = 0; k < tables; ++k)
      of[k] = _mm256_broadcastsi128_si256(_mm_load_si128(reinterpret_cast<const __m128i*>(bytes + 16 * k)));
  }
  void rename(std::uint16_t* labels) const noexcept {
    auto* const to = reinterpret_cast<__m256i*>(labels);
    // A byte with its top bit set finds 0: the upper one of each label, and what is of another table.
    __m256i left = _mm256_or_si256(_mm256_loadu_si256(to), _mm256_set1_epi16(INT16_MIN));
    __m256i found = _mm256_setzero_si256();
    for (std::int32_t k = 0; k < count; ++k) {
      const __m256i at = _mm256_adds_epu8(left, _mm256_set1_epi8(0x70));
      found = _mm256_or_si256(found, _mm256_shuffle_epi8(of[k], at));
      left = _mm256_sub_epi8(left, _mm256_set1_epi8(16));
    }
    _mm256_storeu_si256(to, found);
  }
};
#endif

}  // namespace

void rename_row(std::uint16_t* labels, std::int32_t count, const std::uint16_t* by,
                std::int32_t names) noexcept {
  std::int32_t x = 0;
  if (names <= most_names && count >= at_once) {
    const Names all(by, names);
    for (; x + at_once <= count; x += at_once) all.rename(labels + x);
  }
  for (; x < count; ++x) labels[x] = by[labels[x]];
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
