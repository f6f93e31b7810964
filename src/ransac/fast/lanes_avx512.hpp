// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

// AVX-512 with BW, DQ and VL: 512 bits, and masks of one bit a lane.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Floats {
  static constexpr std::int32_t count = 16;
  using Mask = __mmask16;
  __m512 v;

  static Floats all(float value) noexcept { return {_mm512_set1_ps(value)}; }
  static Floats load(const float* numbers) noexcept { return {_mm512_loadu_ps(numbers)}; }
  static Floats load(const std::uint16_t* numbers) noexcept {
    const __m256i words = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
    return {_mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(words))};
  }
  static Floats load(const float* numbers, std::ptrdiff_t step) noexcept {
    const __m512i index = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    return {_mm512_i32gather_ps(_mm512_mullo_epi32(index, _mm512_set1_epi32(static_cast<std::int32_t>(step))),
                                numbers, 4)};
  }
  void store(float* numbers) const noexcept { _mm512_storeu_ps(numbers, v); }

  Floats operator+(Floats b) const noexcept { return {_mm512_add_ps(v, b.v)}; }
  Floats operator-(Floats b) const noexcept { return {_mm512_sub_ps(v, b.v)}; }
  Floats operator*(Floats b) const noexcept { return {_mm512_mul_ps(v, b.v)}; }
  Floats operator/(Floats b) const noexcept { return {_mm512_div_ps(v, b.v)}; }
  Mask operator<(Floats b) const noexcept { return _mm512_cmp_ps_mask(v, b.v, _CMP_LT_OQ); }
  Mask operator<=(Floats b) const noexcept { return _mm512_cmp_ps_mask(v, b.v, _CMP_LE_OQ); }
  Mask operator==(Floats b) const noexcept { return _mm512_cmp_ps_mask(v, b.v, _CMP_EQ_OQ); }
  Floats magnitude() const noexcept { return {_mm512_abs_ps(v)}; }
  /// The sum in the lanes that are in the mask.
  Floats plus(Floats b, Mask mask) const noexcept { return {_mm512_mask_add_ps(v, mask, v, b.v)}; }
  /// 0 in the lanes that are not in the mask.
  Floats where(Mask mask) const noexcept { return {_mm512_maskz_mov_ps(mask, v)}; }
};

/// The second where the first is not a number.
inline Floats min(Floats a, Floats b) noexcept {
  return {_mm512_min_ps(a.v, b.v)};
}
inline Floats max(Floats a, Floats b) noexcept {
  return {_mm512_max_ps(a.v, b.v)};
}
/// Lanes with label 0.
inline Floats::Mask unlabelled(const std::uint16_t* labels) noexcept {
  const __m256i words = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(labels));
  return _mm256_testn_epi16_mask(words, words);
}
inline Floats::Mask both(Floats::Mask a, Floats::Mask b) noexcept {
  return static_cast<Floats::Mask>(a & b);
}
inline bool all_of(Floats::Mask mask) noexcept {
  return mask == 0xFFFF;
}
/// Lanes of the mask in which a is less.
inline Floats::Mask less_where(Floats::Mask mask, Floats a, Floats b) noexcept {
  return _mm512_mask_cmp_ps_mask(mask, a.v, b.v, _CMP_LT_OQ);
}
inline std::uint32_t count_of(Floats::Mask mask) noexcept {
  return static_cast<std::uint32_t>(_mm_popcnt_u32(mask));
}

/// One bit a lane.
inline void store_bits(Floats::Mask mask, std::uint8_t* bytes) noexcept {
  __builtin_memcpy(bytes, &mask, sizeof mask);
}

/// Sixteen partial sums, added up 8 apart, 4, 2, 1.
inline float fold(const float* sums) noexcept {
  const __m512 all = _mm512_load_ps(sums);
  const __m256 eight = _mm256_add_ps(_mm512_castps512_ps256(all), _mm512_extractf32x8_ps(all, 1));
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
