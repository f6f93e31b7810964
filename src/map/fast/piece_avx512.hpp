// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "map/plane_row.hpp"

// AVX-512: sixteen pixels at a time.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Adds `count` pixels, at most 16, from pixel n on.
inline void add_pixels(detail::PlaneRun& run, const PlaneRowPlaces& p, std::int32_t n,
                       std::int32_t count) noexcept {
  const auto some = static_cast<__mmask16>((1U << static_cast<unsigned>(count)) - 1);
  const auto in_leaf = [n, some](const std::int32_t* at) {
    const __m512i low =
        _mm512_and_si512(_mm512_loadu_si512(at + n), _mm512_set1_epi32(plane_row::leaf_side - 1));
    return _mm512_maskz_cvtepi32_epi16(some,
                                       _mm512_sub_epi32(low, _mm512_set1_epi32(plane_row::leaf_side / 2)));
  };
  const __m256i x = in_leaf(p.i + p.guard), y = in_leaf(p.j + p.guard), z = in_leaf(p.k + p.guard);
  const auto pair = [](__m256i low, __m256i high) {
    return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
  };
  const __m512i x_y = pair(x, y), ones = _mm512_set1_epi16(1);
  const __m512i a = _mm512_madd_epi16(x_y, x_y);                // xx yy
  const __m512i b = _mm512_madd_epi16(x_y, pair(y, z));         // xy yz
  const __m512i c = _mm512_madd_epi16(pair(z, x), pair(z, z));  // zz xz
  const __m512i d = _mm512_madd_epi16(x_y, ones);               // x y
  const __m512i ab = _mm512_add_epi32(_mm512_unpacklo_epi32(a, b), _mm512_unpackhi_epi32(a, b));
  const __m512i cd = _mm512_add_epi32(_mm512_unpacklo_epi32(c, d), _mm512_unpackhi_epi32(c, d));
  const __m512i abcd = _mm512_add_epi32(_mm512_unpacklo_epi64(ab, cd), _mm512_unpackhi_epi64(ab, cd));
  // Quarters 0 and 1 make the first half of the run's sums, 2 and 3 the second.
  const __m512i even = _mm512_shuffle_i64x2(abcd, abcd, _MM_SHUFFLE(2, 0, 2, 0));
  const __m512i odd = _mm512_shuffle_i64x2(abcd, abcd, _MM_SHUFFLE(3, 1, 3, 1));
  const __m256i sums = _mm512_castsi512_si256(_mm512_add_epi32(even, odd));
  auto* const into = reinterpret_cast<__m256i*>(run.sum);
  _mm256_store_si256(into, _mm256_add_epi32(_mm256_load_si256(into), sums));

  const __m512i r = _mm512_maskz_loadu_epi32(some, p.residual + p.guard + n);
  const __m512i r_odd = _mm512_srli_epi64(r, 32);
  const __m512i rr = _mm512_add_epi64(_mm512_mul_epi32(r, r), _mm512_mul_epi32(r_odd, r_odd));
  const __m512i zs = _mm512_cvtepi32_epi64(_mm256_madd_epi16(z, _mm256_set1_epi16(1)));
  const __m512i zr = _mm512_add_epi64(_mm512_unpacklo_epi64(zs, rr), _mm512_unpackhi_epi64(zs, rr));
  const __m256i half = _mm256_add_epi64(_mm512_castsi512_si256(zr), _mm512_extracti64x4_epi64(zr, 1));
  const __m128i both = _mm_add_epi64(_mm256_castsi256_si128(half), _mm256_extracti128_si256(half, 1));
  auto* const z_residual = reinterpret_cast<__m128i*>(&run.z);
  _mm_store_si128(z_residual, _mm_add_epi64(_mm_load_si128(z_residual), both));
  run.readings += count;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
