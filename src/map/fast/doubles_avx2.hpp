// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

// AVX2: four numbers.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Doubles {
  static constexpr std::int32_t count = 4;
  __m256d v;

  static Doubles all(double value) noexcept { return {_mm256_set1_pd(value)}; }
  static Doubles counted_from(std::int32_t first) noexcept {
    const __m128i lanes = _mm_setr_epi32(0, 1, 2, 3);
    return {_mm256_cvtepi32_pd(_mm_add_epi32(_mm_set1_epi32(first), lanes))};
  }
  static Doubles load(const std::uint16_t* numbers) noexcept {
    const __m128i four = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers));
    return {_mm256_cvtepi32_pd(_mm_cvtepu16_epi32(four))};
  }
  /// Rounded towards zero. Neither a value beyond the bounds nor NaN comes through: that becomes the bound.
  __m128i whole(double bound) const noexcept {
    const __m256d below = _mm256_min_pd(v, _mm256_set1_pd(bound));
    return _mm256_cvttpd_epi32(_mm256_max_pd(below, _mm256_set1_pd(-bound)));
  }

  Doubles operator+(Doubles b) const noexcept { return {_mm256_add_pd(v, b.v)}; }
  Doubles operator-(Doubles b) const noexcept { return {_mm256_sub_pd(v, b.v)}; }
  Doubles operator*(Doubles b) const noexcept { return {_mm256_mul_pd(v, b.v)}; }
  Doubles operator/(Doubles b) const noexcept { return {_mm256_div_pd(v, b.v)}; }
};

struct Wholes {
  static constexpr std::int32_t count = 8;
  using Mask = __m256i;
  __m256i v;

  static Wholes all(std::int32_t value) noexcept { return {_mm256_set1_epi32(value)}; }
  static Wholes of(Doubles low, Doubles high, double bound) noexcept {
    return {_mm256_set_m128i(high.whole(bound), low.whole(bound))};
  }
  void store(std::int32_t* to) const noexcept { _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), v); }

  Wholes operator|(Wholes b) const noexcept { return {_mm256_or_si256(v, b.v)}; }
  Wholes operator^(Wholes b) const noexcept { return {_mm256_xor_si256(v, b.v)}; }
  Wholes magnitude() const noexcept { return {_mm256_abs_epi32(v)}; }
  Mask above(std::int32_t limit) const noexcept { return _mm256_cmpgt_epi32(v, all(limit).v); }
  /// Of these as numbers without a sign; the limit is 2^bits − 1.
  Mask above_bits(std::int32_t bits) const noexcept {
    const __m256i zero = _mm256_setzero_si256();
    return _mm256_xor_si256(_mm256_cmpeq_epi32(_mm256_srli_epi32(v, bits), zero), all(-1).v);
  }
  static Mask either(Mask a, Mask b) noexcept { return _mm256_or_si256(a, b); }
  static std::uint32_t bits(Mask mask) noexcept {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask)));
  }
  Wholes or_where(Mask mask, std::int32_t value) const noexcept {
    return {_mm256_or_si256(v, _mm256_and_si256(mask, all(value).v))};
  }
  /// Every lane gets the one before it, the first one `before`.
  Wholes shifted(std::int32_t before) const noexcept {
    const __m256i turned = _mm256_permutevar8x32_epi32(v, _mm256_setr_epi32(7, 0, 1, 2, 3, 4, 5, 6));
    return {_mm256_blend_epi32(turned, all(before).v, 1)};
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
