// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../gather_row.cpp; read that first.
#include <immintrin.h>

#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

#if defined(__AVX512F__)

/// Which of some cells are readings, and what moves these together.
struct Some {
  static constexpr std::int32_t cells = 16;
  __mmask16 readings;

  /// `there`: bits of those that are in the row.
  Some(const float* q, std::uint32_t there) noexcept
      : readings(_mm512_mask_cmp_ps_mask(static_cast<__mmask16>(there), _mm512_loadu_ps(q),
                                         _mm512_setzero_ps(), _CMP_GT_OQ)) {}
  std::uint32_t count() const noexcept {
    return static_cast<std::uint32_t>(__builtin_popcount(_cvtmask16_u32(readings)));
  }
  void put(const float* from, float less, float* to) const noexcept {
    const __m512 x = _mm512_sub_ps(_mm512_loadu_ps(from), _mm512_set1_ps(less));
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(readings, x));
  }
};

#else

/// Numbers 0 to 7 in the order in which those of set bits come first.
struct Orders {
  alignas(32) std::int32_t of[256][8];

  constexpr Orders() noexcept : of{} {
    for (std::uint32_t bits = 0; bits < 256; ++bits) {
      std::int32_t* next = of[bits];
      for (std::int32_t i = 0; i < 8; ++i)
        if ((bits >> static_cast<std::uint32_t>(i) & 1U) != 0) *next++ = i;
    }
  }
};
constexpr Orders orders;

/// Which of some cells are readings, and what moves these together.
struct Some {
  static constexpr std::int32_t cells = 8;
  std::uint32_t readings;

  /// `there`: bits of those that are in the row.
  Some(const float* q, std::uint32_t there) noexcept
      : readings(there & static_cast<std::uint32_t>(_mm256_movemask_ps(
                             _mm256_cmp_ps(_mm256_loadu_ps(q), _mm256_setzero_ps(), _CMP_GT_OQ)))) {}
  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(__builtin_popcount(readings)); }
  void put(const float* from, float less, float* to) const noexcept {
    const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(orders.of[readings]));
    const __m256 x = _mm256_sub_ps(_mm256_loadu_ps(from), _mm256_set1_ps(less));
    _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(x, order));
  }
};

#endif

}  // namespace

std::uint32_t gather_row(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                         const GatheredReadings& out) noexcept {
  constexpr std::uint32_t all = (1U << static_cast<std::uint32_t>(Some::cells)) - 1U;
  std::uint32_t k = 0;
  for (std::int32_t c = 0; c < columns; c += Some::cells) {
    const std::int32_t rest = columns - c;
    const Some some(row.q + c, rest < Some::cells ? (1U << static_cast<std::uint32_t>(rest)) - 1U : all);
    some.put(row.u + c, u0, out.u + k);
    some.put(row.v + c, v0, out.v + k);
    some.put(row.q + c, 0, out.q + k);
    some.put(row.w + c, 0, out.w + k);
    k += some.count();
  }
  return k;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
