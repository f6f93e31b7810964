// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

// AVX-512: eight numbers.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Doubles {
  static constexpr std::int32_t count = 8;
  __m512d v;

  static Doubles all(double value) noexcept { return {_mm512_set1_pd(value)}; }
  static Doubles counted_from(std::int32_t first) noexcept {
    const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    return {_mm512_cvtepi32_pd(_mm256_add_epi32(_mm256_set1_epi32(first), lanes))};
  }
  static Doubles load(const std::uint16_t* numbers) noexcept {
    const __m128i eight = _mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers));
    return {_mm512_cvtepi32_pd(_mm256_cvtepu16_epi32(eight))};
  }
  /// Rounded towards zero. Neither a value beyond the bounds nor NaN comes through: that becomes the bound.
  __m256i whole(double bound) const noexcept {
    const __m512d below = _mm512_min_pd(v, _mm512_set1_pd(bound));
    return _mm512_cvttpd_epi32(_mm512_max_pd(below, _mm512_set1_pd(-bound)));
  }

  Doubles operator+(Doubles b) const noexcept { return {_mm512_add_pd(v, b.v)}; }
  Doubles operator-(Doubles b) const noexcept { return {_mm512_sub_pd(v, b.v)}; }
  Doubles operator*(Doubles b) const noexcept { return {_mm512_mul_pd(v, b.v)}; }
  Doubles operator/(Doubles b) const noexcept { return {_mm512_div_pd(v, b.v)}; }
};

struct Wholes {
  static constexpr std::int32_t count = 16;
  using Mask = __mmask16;
  __m512i v;

  static Wholes all(std::int32_t value) noexcept { return {_mm512_set1_epi32(value)}; }
  static Wholes of(Doubles low, Doubles high, double bound) noexcept {
    return {_mm512_inserti64x4(_mm512_castsi256_si512(low.whole(bound)), high.whole(bound), 1)};
  }
  void store(std::int32_t* to) const noexcept { _mm512_storeu_si512(to, v); }

  Wholes operator|(Wholes b) const noexcept { return {_mm512_or_si512(v, b.v)}; }
  Wholes operator^(Wholes b) const noexcept { return {_mm512_xor_si512(v, b.v)}; }
  Wholes magnitude() const noexcept { return {_mm512_abs_epi32(v)}; }
  Mask above(std::int32_t limit) const noexcept { return _mm512_cmpgt_epi32_mask(v, all(limit).v); }
  /// Of these as numbers without a sign; the limit is 2^bits − 1.
  Mask above_bits(std::int32_t bits) const noexcept {
    return _mm512_cmpgt_epu32_mask(v, all((1 << bits) - 1).v);
  }
  static Mask either(Mask a, Mask b) noexcept { return static_cast<Mask>(a | b); }
  static std::uint32_t bits(Mask mask) noexcept { return mask; }
  Wholes or_where(Mask mask, std::int32_t value) const noexcept {
    return {_mm512_mask_or_epi32(v, mask, v, all(value).v)};
  }
  /// Every lane gets the one before it, the first one `before`.
  Wholes shifted(std::int32_t before) const noexcept { return {_mm512_alignr_epi32(v, all(before).v, 15)}; }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
