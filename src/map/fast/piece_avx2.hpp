// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "map/plane_row.hpp"

// AVX2: sixteen pixels in two halves, whose numbers of 16 bits then fill one vector.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

inline __m256i eight_at(const std::int32_t* numbers) noexcept {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
}

/// Adds `count` pixels, at most 16, from pixel n on.
inline void add_pixels(detail::PlaneRun& run, const PlaneRowPlaces& p, std::int32_t n,
                       std::int32_t count) noexcept {
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), counts = _mm256_set1_epi32(count);
  const __m256i some[2] = {_mm256_cmpgt_epi32(counts, lanes),
                           _mm256_cmpgt_epi32(counts, _mm256_add_epi32(lanes, _mm256_set1_epi32(8)))};
  n += p.guard;
  const auto in_leaf = [&](const std::int32_t* at, int half) {
    const __m256i low =
        _mm256_and_si256(eight_at(at + 8 * half), _mm256_set1_epi32(plane_row::leaf_side - 1));
    return _mm256_and_si256(_mm256_sub_epi32(low, _mm256_set1_epi32(plane_row::leaf_side / 2)), some[half]);
  };
  const auto sixteen = [&](const std::int32_t* at) {
    return _mm256_packs_epi32(in_leaf(at + n, 0), in_leaf(at + n, 1));
  };
  const __m256i x = sixteen(p.i), y = sixteen(p.j), z = sixteen(p.k), ones = _mm256_set1_epi16(1);
  const auto fold = [](__m256i a, __m256i b) {
    return _mm256_add_epi32(_mm256_unpacklo_epi32(a, b), _mm256_unpackhi_epi32(a, b));
  };
  const auto four = [&](__m256i a, __m256i b, __m256i c, __m256i d) {
    const __m256i ab = fold(a, b), cd = fold(c, d);
    const __m256i all = _mm256_add_epi32(_mm256_unpacklo_epi64(ab, cd), _mm256_unpackhi_epi64(ab, cd));
    return _mm_add_epi32(_mm256_castsi256_si128(all), _mm256_extracti128_si256(all, 1));
  };
  const auto add = [](std::int32_t* into, __m128i sums) {
    auto* const at = reinterpret_cast<__m128i*>(into);
    _mm_store_si128(at, _mm_add_epi32(_mm_load_si128(at), sums));
  };
  add(run.sum, four(_mm256_madd_epi16(x, x), _mm256_madd_epi16(x, y), _mm256_madd_epi16(z, z),
                    _mm256_madd_epi16(x, ones)));
  add(run.sum + 4, four(_mm256_madd_epi16(y, y), _mm256_madd_epi16(y, z), _mm256_madd_epi16(x, z),
                        _mm256_madd_epi16(y, ones)));

  __m256i rr = _mm256_setzero_si256();
  for (int half = 0; half < 2; ++half) {
    const __m256i r = _mm256_and_si256(eight_at(p.residual + n + 8 * half), some[half]);
    const __m256i odd = _mm256_srli_epi64(r, 32);
    rr = _mm256_add_epi64(rr, _mm256_add_epi64(_mm256_mul_epi32(r, r), _mm256_mul_epi32(odd, odd)));
  }
  const __m256i z4 = _mm256_madd_epi16(z, ones);
  const __m256i zs =
      _mm256_cvtepi32_epi64(_mm_add_epi32(_mm256_castsi256_si128(z4), _mm256_extracti128_si256(z4, 1)));
  const __m256i zr = _mm256_add_epi64(_mm256_unpacklo_epi64(zs, rr), _mm256_unpackhi_epi64(zs, rr));
  const __m128i both = _mm_add_epi64(_mm256_castsi256_si128(zr), _mm256_extracti128_si256(zr, 1));
  auto* const z_residual = reinterpret_cast<__m128i*>(&run.z);
  _mm_store_si128(z_residual, _mm_add_epi64(_mm_load_si128(z_residual), both));
  run.readings += count;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
