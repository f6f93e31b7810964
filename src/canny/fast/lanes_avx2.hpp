// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include <cstdint>

// AVX2: 256 bits.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Lanes16 {
  static constexpr std::int32_t count = 16;
  using Mask = __m256i;
  __m256i v;

  static Lanes16 all(std::int32_t value) noexcept { return {_mm256_set1_epi16(static_cast<short>(value))}; }
  static Lanes16 load(const void* numbers) noexcept {
    return {_mm256_loadu_si256(static_cast<const __m256i*>(numbers))};
  }
  static Lanes16 load_gradient(const std::int16_t* numbers) noexcept { return load(numbers); }
  static Lanes16 load_bytes(const std::uint8_t* bytes) noexcept {
    return {_mm256_cvtepu8_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes)))};
  }
  void store(void* numbers) const noexcept { _mm256_storeu_si256(static_cast<__m256i*>(numbers), v); }

  Lanes16 operator+(Lanes16 b) const noexcept { return {_mm256_add_epi16(v, b.v)}; }
  Lanes16 operator-(Lanes16 b) const noexcept { return {_mm256_sub_epi16(v, b.v)}; }
  Lanes16 operator*(Lanes16 b) const noexcept { return {_mm256_mullo_epi16(v, b.v)}; }
  Lanes16 operator^(Lanes16 b) const noexcept { return {_mm256_xor_si256(v, b.v)}; }
  Mask operator>(Lanes16 b) const noexcept { return _mm256_cmpgt_epi16(v, b.v); }
  Mask negative() const noexcept { return _mm256_srai_epi16(v, 15); }
  Lanes16 magnitude() const noexcept { return {_mm256_abs_epi16(v)}; }
  Lanes16 times_high(std::int32_t factor) const noexcept { return {_mm256_mulhi_epu16(v, all(factor).v)}; }
};

struct Lanes32 {
  static constexpr std::int32_t count = 8;
  using Mask = __m256i;
  __m256i v;

  static Lanes32 all(std::int32_t value) noexcept { return {_mm256_set1_epi32(value)}; }
  static Lanes32 load(const void* numbers) noexcept {
    return {_mm256_loadu_si256(static_cast<const __m256i*>(numbers))};
  }
  static Lanes32 load_gradient(const std::int16_t* numbers) noexcept {
    return {_mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers)))};
  }

  Lanes32 operator+(Lanes32 b) const noexcept { return {_mm256_add_epi32(v, b.v)}; }
  Lanes32 operator-(Lanes32 b) const noexcept { return {_mm256_sub_epi32(v, b.v)}; }
  Lanes32 operator^(Lanes32 b) const noexcept { return {_mm256_xor_si256(v, b.v)}; }
  Mask operator>(Lanes32 b) const noexcept { return _mm256_cmpgt_epi32(v, b.v); }
  Mask negative() const noexcept { return _mm256_srai_epi32(v, 31); }
  Lanes32 magnitude() const noexcept { return {_mm256_abs_epi32(v)}; }
  Lanes32 times_high(std::int32_t factor) const noexcept {
    return {_mm256_srli_epi32(_mm256_madd_epi16(v, all(factor).v), 16)};
  }
};

inline Lanes16 max(Lanes16 a, Lanes16 b) noexcept {
  return {_mm256_max_epi16(a.v, b.v)};
}
inline Lanes32 max(Lanes32 a, Lanes32 b) noexcept {
  return {_mm256_max_epi32(a.v, b.v)};
}
template <class Lanes>
Lanes select(__m256i mask, Lanes yes, Lanes no) noexcept {
  return {_mm256_blendv_epi8(no.v, yes.v, mask)};
}
inline __m256i both(__m256i a, __m256i b) noexcept {
  return _mm256_and_si256(a, b);
}
inline bool any(__m256i mask) noexcept {
  return _mm256_testz_si256(mask, mask) == 0;
}

/// dx² + dy², two 16-bit numbers at once, in the order of the lanes.
inline void store_squares(Lanes16 dx, Lanes16 dy, std::uint32_t* sums) noexcept {
  const __m256i low = _mm256_unpacklo_epi16(dx.v, dy.v), high = _mm256_unpackhi_epi16(dx.v, dy.v);
  const __m256i a = _mm256_madd_epi16(low, low), b = _mm256_madd_epi16(high, high);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums), _mm256_permute2x128_si256(a, b, 0x20));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + 8), _mm256_permute2x128_si256(a, b, 0x31));
}

/// A byte a lane: 0, 1 where `kept`, 2 where `strong` too.
inline void store_classes(Lanes16, __m256i kept, __m256i strong, std::uint8_t* classes) noexcept {
  const __m256i numbers = _mm256_abs_epi16(_mm256_add_epi16(kept, strong));
  const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packus_epi16(numbers, numbers), 0x08);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(classes), _mm256_castsi256_si128(bytes));
}
inline void store_classes(Lanes32, __m256i kept, __m256i strong, std::uint8_t* classes) noexcept {
  const __m256i numbers = _mm256_abs_epi32(_mm256_add_epi32(kept, strong));
  const __m128i words =
      _mm_packs_epi32(_mm256_castsi256_si128(numbers), _mm256_extracti128_si256(numbers, 1));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(classes), _mm_packus_epi16(words, words));
}

inline std::uint32_t count_of(Lanes16, __m256i mask) noexcept {
  const auto two_a_lane = static_cast<std::uint32_t>(_mm256_movemask_epi8(mask));
  return static_cast<std::uint32_t>(__builtin_popcount(two_a_lane)) / 2;
}
inline std::uint32_t count_of(Lanes32, __m256i mask) noexcept {
  const auto bits = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask)));
  return static_cast<std::uint32_t>(__builtin_popcount(bits));
}

inline std::uint64_t bits_above(const std::uint8_t* bytes, char limit) noexcept {
  const __m256i limits = _mm256_set1_epi8(limit);
  const __m256i left = _mm256_cmpgt_epi8(Lanes16::load(bytes).v, limits);
  const __m256i right = _mm256_cmpgt_epi8(Lanes16::load(bytes + 32).v, limits);
  const std::uint64_t high = static_cast<std::uint32_t>(_mm256_movemask_epi8(right));
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(left)) | (high << 32U);
}

/// A bit for each of 64 bytes that are 0, 1 or 2.
inline std::uint64_t bits_above_0(const std::uint8_t* bytes) noexcept {
  return bits_above(bytes, 0);
}
inline std::uint64_t bits_above_1(const std::uint8_t* bytes) noexcept {
  return bits_above(bytes, 1);
}

inline void spread_half(std::uint32_t bits, std::uint8_t* bytes) noexcept {
  const __m256i eight_each =
      _mm256_setr_epi64x(0, 0x0101010101010101, 0x0202020202020202, 0x0303030303030303);
  const __m256i own_bit = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201U));
  const __m256i copies = _mm256_shuffle_epi8(_mm256_set1_epi32(static_cast<int>(bits)), eight_each);
  Lanes16{_mm256_cmpeq_epi8(_mm256_and_si256(copies, own_bit), own_bit)}.store(bytes);
}

/// The other way, with 255 where the bit is set.
inline void spread_bits(std::uint64_t bits, std::uint8_t* bytes) noexcept {
  spread_half(static_cast<std::uint32_t>(bits), bytes);
  spread_half(static_cast<std::uint32_t>(bits >> 32U), bytes + 32);
}

inline std::uint32_t count_of(std::uint64_t bits) noexcept {
  return static_cast<std::uint32_t>(__builtin_popcountll(bits));
}

/// 32-bit sums of products, one a lane of Lanes16: those of even lanes, and those of odd ones.
struct ProductSums {
  __m256i even, odd;
  static ProductSums all(std::int32_t value) noexcept {
    return {_mm256_set1_epi32(value), _mm256_set1_epi32(value)};
  }
  /// To lanes 2 i and 2 i + 1 the products of these two numbers with two factors each, the one of number 2 i
  /// in the low half.
  void add(Lanes16 numbers, std::int32_t to_even, std::int32_t to_odd) noexcept {
    even = _mm256_add_epi32(even, _mm256_madd_epi16(numbers.v, _mm256_set1_epi32(to_even)));
    odd = _mm256_add_epi32(odd, _mm256_madd_epi16(numbers.v, _mm256_set1_epi32(to_odd)));
  }
  /// The sums divided by 65536, which must fit a byte.
  void store_bytes(std::uint8_t* bytes) const noexcept {
    const __m256i numbers = _mm256_blend_epi16(_mm256_srli_epi32(even, 16), odd, 0xAA);
    const __m256i packed = _mm256_permute4x64_epi64(_mm256_packus_epi16(numbers, numbers), 0x08);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(bytes), _mm256_castsi256_si128(packed));
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
