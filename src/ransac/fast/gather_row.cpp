// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../gather_row.cpp; read that first.
#include <immintrin.h>

#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

#if defined(__AVX512F__)

std::uint32_t gather_row(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                         const GatheredReadings& out) noexcept {
  const __m512 left = _mm512_set1_ps(u0), top = _mm512_set1_ps(v0);
  std::uint32_t k = 0;
  for (std::int32_t c = 0; c < columns; c += search_lanes) {
    const std::int32_t rest = columns - c;
    const std::uint32_t there = rest < search_lanes ? (1U << static_cast<std::uint32_t>(rest)) - 1U : 0xFFFFU;
    const __m512 q = _mm512_loadu_ps(row.q + c);
    const __mmask16 reads =
        _mm512_mask_cmp_ps_mask(static_cast<__mmask16>(there), q, _mm512_setzero_ps(), _CMP_GT_OQ);
    const auto put = [reads, k](float* to, __m512 x) noexcept {
      _mm512_storeu_ps(to + k, _mm512_maskz_compress_ps(reads, x));
    };
    put(out.u, _mm512_sub_ps(_mm512_loadu_ps(row.u + c), left));
    put(out.v, _mm512_sub_ps(_mm512_loadu_ps(row.v + c), top));
    put(out.q, q);
    put(out.w, _mm512_loadu_ps(row.w + c));
    k += static_cast<std::uint32_t>(__builtin_popcount(_cvtmask16_u32(reads)));
  }
  return k;
}

#else

namespace {

/// Numbers 0 to 7 in the order in which those of set bits come first: what moves readings together.
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

}  // namespace

std::uint32_t gather_row(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                         const GatheredReadings& out) noexcept {
  const __m256 left = _mm256_set1_ps(u0), top = _mm256_set1_ps(v0);
  std::uint32_t k = 0;
  for (std::int32_t c = 0; c < columns; c += 8) {
    const std::int32_t rest = columns - c;
    const std::uint32_t there = rest < 8 ? (1U << static_cast<std::uint32_t>(rest)) - 1U : 0xFFU;
    const __m256 q = _mm256_loadu_ps(row.q + c);
    const auto above =
        static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(q, _mm256_setzero_ps(), _CMP_GT_OQ)));
    const std::uint32_t reads = above & there;
    const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(orders.of[reads]));
    const auto put = [order, k](float* to, __m256 x) noexcept {
      _mm256_storeu_ps(to + k, _mm256_permutevar8x32_ps(x, order));
    };
    put(out.u, _mm256_sub_ps(_mm256_loadu_ps(row.u + c), left));
    put(out.v, _mm256_sub_ps(_mm256_loadu_ps(row.v + c), top));
    put(out.q, q);
    put(out.w, _mm256_loadu_ps(row.w + c));
    k += static_cast<std::uint32_t>(__builtin_popcount(reads));
  }
  return k;
}

#endif

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
