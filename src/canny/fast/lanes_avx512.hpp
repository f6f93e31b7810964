// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

// AVX-512 with BW, DQ and VL: 512 bits, and masks of one bit a lane.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Lanes16 {
  static constexpr std::int32_t count = 32;
  using Mask = __mmask32;
  __m512i v;

  static Lanes16 all(std::int32_t value) noexcept { return {_mm512_set1_epi16(static_cast<short>(value))}; }
  static Lanes16 load(const void* numbers) noexcept { return {_mm512_loadu_si512(numbers)}; }
  static Lanes16 load_gradient(const std::int16_t* numbers) noexcept { return load(numbers); }
  static Lanes16 load_bytes(const std::uint8_t* bytes) noexcept {
    return {_mm512_cvtepu8_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(bytes)))};
  }
  void store(void* numbers) const noexcept { _mm512_storeu_si512(numbers, v); }

  Lanes16 operator+(Lanes16 b) const noexcept { return {_mm512_add_epi16(v, b.v)}; }
  Lanes16 operator-(Lanes16 b) const noexcept { return {_mm512_sub_epi16(v, b.v)}; }
  Lanes16 operator*(Lanes16 b) const noexcept { return {_mm512_mullo_epi16(v, b.v)}; }
  Lanes16 operator^(Lanes16 b) const noexcept { return {_mm512_xor_si512(v, b.v)}; }
  Mask operator>(Lanes16 b) const noexcept { return _mm512_cmpgt_epi16_mask(v, b.v); }
  Mask negative() const noexcept { return _mm512_movepi16_mask(v); }
  Lanes16 magnitude() const noexcept { return {_mm512_abs_epi16(v)}; }
  Lanes16 times_high(std::int32_t factor) const noexcept { return {_mm512_mulhi_epu16(v, all(factor).v)}; }
};

struct Lanes32 {
  static constexpr std::int32_t count = 16;
  using Mask = __mmask16;
  __m512i v;

  static Lanes32 all(std::int32_t value) noexcept { return {_mm512_set1_epi32(value)}; }
  static Lanes32 load(const void* numbers) noexcept { return {_mm512_loadu_si512(numbers)}; }
  static Lanes32 load_gradient(const std::int16_t* numbers) noexcept {
    return {_mm512_cvtepi16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)))};
  }

  Lanes32 operator+(Lanes32 b) const noexcept { return {_mm512_add_epi32(v, b.v)}; }
  Lanes32 operator-(Lanes32 b) const noexcept { return {_mm512_sub_epi32(v, b.v)}; }
  Lanes32 operator^(Lanes32 b) const noexcept { return {_mm512_xor_si512(v, b.v)}; }
  Mask operator>(Lanes32 b) const noexcept { return _mm512_cmpgt_epi32_mask(v, b.v); }
  Mask negative() const noexcept { return _mm512_movepi32_mask(v); }
  Lanes32 magnitude() const noexcept { return {_mm512_abs_epi32(v)}; }
  Lanes32 times_high(std::int32_t factor) const noexcept {
    return {_mm512_srli_epi32(_mm512_madd_epi16(v, all(factor).v), 16)};
  }
};

inline Lanes16 max(Lanes16 a, Lanes16 b) noexcept {
  return {_mm512_max_epi16(a.v, b.v)};
}
inline Lanes32 max(Lanes32 a, Lanes32 b) noexcept {
  return {_mm512_max_epi32(a.v, b.v)};
}
inline Lanes16 select(__mmask32 mask, Lanes16 yes, Lanes16 no) noexcept {
  return {_mm512_mask_blend_epi16(mask, no.v, yes.v)};
}
inline Lanes32 select(__mmask16 mask, Lanes32 yes, Lanes32 no) noexcept {
  return {_mm512_mask_blend_epi32(mask, no.v, yes.v)};
}
template <class Mask>
Mask both(Mask a, Mask b) noexcept {
  return static_cast<Mask>(a & b);
}
template <class Mask>
bool any(Mask mask) noexcept {
  return mask != 0;
}

/// dx² + dy², two 16-bit numbers at once, in the order of the lanes.
inline void store_squares(Lanes16 dx, Lanes16 dy, std::uint32_t* sums) noexcept {
  const __m512i low = _mm512_unpacklo_epi16(dx.v, dy.v), high = _mm512_unpackhi_epi16(dx.v, dy.v);
  const __m512i a = _mm512_madd_epi16(low, low), b = _mm512_madd_epi16(high, high);
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
  const __m512i second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  _mm512_storeu_si512(sums, _mm512_permutex2var_epi64(a, first, b));
  _mm512_storeu_si512(sums + 16, _mm512_permutex2var_epi64(a, second, b));
}

/// A byte a lane: 0, 1 where `kept`, 2 where `strong` too.
inline void store_classes(Lanes16, __mmask32 kept, __mmask32 strong, std::uint8_t* classes) noexcept {
  const __m256i ones = _mm256_maskz_set1_epi8(kept, 1);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(classes), _mm256_mask_set1_epi8(ones, strong, 2));
}
inline void store_classes(Lanes32, __mmask16 kept, __mmask16 strong, std::uint8_t* classes) noexcept {
  const __m128i ones = _mm_maskz_set1_epi8(kept, 1);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(classes), _mm_mask_set1_epi8(ones, strong, 2));
}

template <class Lanes>
std::uint32_t count_of(Lanes, typename Lanes::Mask mask) noexcept {
  return static_cast<std::uint32_t>(__builtin_popcount(mask));
}

/// A bit for each of 64 bytes that are 0, 1 or 2.
inline std::uint64_t bits_above_0(const std::uint8_t* bytes) noexcept {
  return _mm512_test_epi8_mask(_mm512_loadu_si512(bytes), _mm512_set1_epi8(3));
}
inline std::uint64_t bits_above_1(const std::uint8_t* bytes) noexcept {
  return _mm512_test_epi8_mask(_mm512_loadu_si512(bytes), _mm512_set1_epi8(2));
}

/// The other way, with 255 where the bit is set.
inline void spread_bits(std::uint64_t bits, std::uint8_t* bytes) noexcept {
  _mm512_storeu_si512(bytes, _mm512_movm_epi8(bits));
}

inline std::uint32_t count_of(std::uint64_t bits) noexcept {
  return static_cast<std::uint32_t>(__builtin_popcountll(bits));
}

/// 32-bit sums of products, one a lane of Lanes16: those of even lanes, and those of odd ones.
struct ProductSums {
  __m512i even, odd;
  static ProductSums all(std::int32_t value) noexcept {
    return {_mm512_set1_epi32(value), _mm512_set1_epi32(value)};
  }
  /// To lanes 2 i and 2 i + 1 the products of these two numbers with two factors each, the one of number 2 i
  /// in the low half.
  void add(Lanes16 numbers, std::int32_t to_even, std::int32_t to_odd) noexcept {
    even = _mm512_add_epi32(even, _mm512_madd_epi16(numbers.v, _mm512_set1_epi32(to_even)));
    odd = _mm512_add_epi32(odd, _mm512_madd_epi16(numbers.v, _mm512_set1_epi32(to_odd)));
  }
  /// The sums divided by 65536, which must fit a byte.
  void store_bytes(std::uint8_t* bytes) const noexcept {
    const __m512i numbers = _mm512_mask_blend_epi16(0xAAAAAAAA, _mm512_srli_epi32(even, 16), odd);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(bytes), _mm512_cvtepi16_epi8(numbers));
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
