// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

// AVX2: 256 bits, and masks as wide as what they choose from.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Floats {
  static constexpr std::int32_t count = 8;
  struct Mask {
    __m256 v;
    explicit operator bool() const noexcept { return _mm256_movemask_ps(v) != 0; }
  };
  __m256 v;

  static Floats all(float value) noexcept { return {_mm256_set1_ps(value)}; }
  static Floats load(const float* numbers) noexcept { return {_mm256_loadu_ps(numbers)}; }
  static Floats load(const std::uint16_t* numbers) noexcept {
    const __m128i words = _mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers));
    return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(words))};
  }
  static Floats load(const float* numbers, std::ptrdiff_t step) noexcept {
    const __m256i index = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
    return {_mm256_i32gather_ps(
        numbers, _mm256_mullo_epi32(index, _mm256_set1_epi32(static_cast<std::int32_t>(step))), 4)};
  }
  void store(float* numbers) const noexcept { _mm256_storeu_ps(numbers, v); }

  Floats operator+(Floats b) const noexcept { return {_mm256_add_ps(v, b.v)}; }
  Floats operator-(Floats b) const noexcept { return {_mm256_sub_ps(v, b.v)}; }
  Floats operator*(Floats b) const noexcept { return {_mm256_mul_ps(v, b.v)}; }
  Floats operator/(Floats b) const noexcept { return {_mm256_div_ps(v, b.v)}; }
  Mask operator<(Floats b) const noexcept { return {_mm256_cmp_ps(v, b.v, _CMP_LT_OQ)}; }
  Mask operator<=(Floats b) const noexcept { return {_mm256_cmp_ps(v, b.v, _CMP_LE_OQ)}; }
  Mask operator==(Floats b) const noexcept { return {_mm256_cmp_ps(v, b.v, _CMP_EQ_OQ)}; }
  Floats magnitude() const noexcept { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), v)}; }
  /// The sum in the lanes that are in the mask.
  Floats plus(Floats b, Mask mask) const noexcept { return {_mm256_add_ps(v, _mm256_and_ps(mask.v, b.v))}; }
  /// 0 in the lanes that are not in the mask.
  Floats where(Mask mask) const noexcept { return {_mm256_and_ps(mask.v, v)}; }
};

/// The second where the first is not a number.
inline Floats min(Floats a, Floats b) noexcept {
  return {_mm256_min_ps(a.v, b.v)};
}
inline Floats max(Floats a, Floats b) noexcept {
  return {_mm256_max_ps(a.v, b.v)};
}
/// Lanes with label 0.
inline Floats::Mask unlabelled(const std::uint16_t* labels) noexcept {
  const __m128i words = _mm_loadu_si128(reinterpret_cast<const __m128i*>(labels));
  const __m256i wide = _mm256_cvtepu16_epi32(words);
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(wide, _mm256_setzero_si256()))};
}
inline Floats::Mask both(Floats::Mask a, Floats::Mask b) noexcept {
  return {_mm256_and_ps(a.v, b.v)};
}
inline bool all_of(Floats::Mask mask) noexcept {
  return _mm256_movemask_ps(mask.v) == 0xFF;
}
/// Lanes of the mask in which a is less.
inline Floats::Mask less_where(Floats::Mask mask, Floats a, Floats b) noexcept {
  return both(mask, a < b);
}
inline std::uint32_t count_of(Floats::Mask mask) noexcept {
  return static_cast<std::uint32_t>(_mm_popcnt_u32(static_cast<unsigned>(_mm256_movemask_ps(mask.v))));
}

/// One bit a lane.
inline void store_bits(Floats::Mask mask, std::uint8_t* bytes) noexcept {
  *bytes = static_cast<std::uint8_t>(_mm256_movemask_ps(mask.v));
}

/// Sixteen partial sums, added up 8 apart, 4, 2, 1.
inline float fold(const float* sums) noexcept {
  const __m256 eight = _mm256_add_ps(_mm256_load_ps(sums), _mm256_load_ps(sums + 8));
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
