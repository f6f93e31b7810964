// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <emmintrin.h>

#include <cstdint>
#include <cstring>

// SSE2, which every 64-bit x86 processor has: 128 bits.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

struct Lanes16 {
  static constexpr std::int32_t count = 8;
  using Mask = __m128i;
  __m128i v;

  static Lanes16 all(std::int32_t value) noexcept { return {_mm_set1_epi16(static_cast<short>(value))}; }
  static Lanes16 load(const void* numbers) noexcept {
    return {_mm_loadu_si128(static_cast<const __m128i*>(numbers))};
  }
  static Lanes16 load_gradient(const std::int16_t* numbers) noexcept { return load(numbers); }
  static Lanes16 load_bytes(const std::uint8_t* bytes) noexcept {
    const __m128i eight = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(bytes));
    return {_mm_unpacklo_epi8(eight, _mm_setzero_si128())};
  }
  void store(void* numbers) const noexcept { _mm_storeu_si128(static_cast<__m128i*>(numbers), v); }

  Lanes16 operator+(Lanes16 b) const noexcept { return {_mm_add_epi16(v, b.v)}; }
  Lanes16 operator-(Lanes16 b) const noexcept { return {_mm_sub_epi16(v, b.v)}; }
  Lanes16 operator*(Lanes16 b) const noexcept { return {_mm_mullo_epi16(v, b.v)}; }
  Lanes16 operator^(Lanes16 b) const noexcept { return {_mm_xor_si128(v, b.v)}; }
  Mask operator>(Lanes16 b) const noexcept { return _mm_cmpgt_epi16(v, b.v); }
  Mask negative() const noexcept { return _mm_srai_epi16(v, 15); }
  Lanes16 magnitude() const noexcept { return {_mm_max_epi16(v, _mm_sub_epi16(_mm_setzero_si128(), v))}; }
  Lanes16 times_high(std::int32_t factor) const noexcept { return {_mm_mulhi_epu16(v, all(factor).v)}; }
};

struct Lanes32 {
  static constexpr std::int32_t count = 4;
  using Mask = __m128i;
  __m128i v;

  static Lanes32 all(std::int32_t value) noexcept { return {_mm_set1_epi32(value)}; }
  static Lanes32 load(const void* numbers) noexcept {
    return {_mm_loadu_si128(static_cast<const __m128i*>(numbers))};
  }
  static Lanes32 load_gradient(const std::int16_t* numbers) noexcept {
    const __m128i four = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers));
    return {_mm_srai_epi32(_mm_unpacklo_epi16(four, four), 16)};
  }

  Lanes32 operator+(Lanes32 b) const noexcept { return {_mm_add_epi32(v, b.v)}; }
  Lanes32 operator-(Lanes32 b) const noexcept { return {_mm_sub_epi32(v, b.v)}; }
  Lanes32 operator^(Lanes32 b) const noexcept { return {_mm_xor_si128(v, b.v)}; }
  Mask operator>(Lanes32 b) const noexcept { return _mm_cmpgt_epi32(v, b.v); }
  Mask negative() const noexcept { return _mm_srai_epi32(v, 31); }
  Lanes32 magnitude() const noexcept { return {_mm_sub_epi32(_mm_xor_si128(v, negative()), negative())}; }
  Lanes32 times_high(std::int32_t factor) const noexcept {
    return {_mm_srli_epi32(_mm_madd_epi16(v, all(factor).v), 16)};
  }
};

inline Lanes16 max(Lanes16 a, Lanes16 b) noexcept {
  return {_mm_max_epi16(a.v, b.v)};
}
template <class Lanes>
Lanes select(__m128i mask, Lanes yes, Lanes no) noexcept {
  return {_mm_or_si128(_mm_and_si128(mask, yes.v), _mm_andnot_si128(mask, no.v))};
}
inline Lanes32 max(Lanes32 a, Lanes32 b) noexcept {
  return select(a > b, a, b);
}
inline __m128i both(__m128i a, __m128i b) noexcept {
  return _mm_and_si128(a, b);
}
inline bool any(__m128i mask) noexcept {
  return _mm_movemask_epi8(mask) != 0;
}

/// dx² + dy², two 16-bit numbers at once, in the order of the lanes.
inline void store_squares(Lanes16 dx, Lanes16 dy, std::uint32_t* sums) noexcept {
  const __m128i low = _mm_unpacklo_epi16(dx.v, dy.v), high = _mm_unpackhi_epi16(dx.v, dy.v);
  const __m128i a = _mm_madd_epi16(low, low), b = _mm_madd_epi16(high, high);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(sums), a);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(sums + 4), b);
}

/// A byte a lane: 0, 1 where `kept`, 2 where `strong` too.
inline void store_classes(Lanes16, __m128i kept, __m128i strong, std::uint8_t* classes) noexcept {
  const __m128i numbers = _mm_sub_epi16(_mm_setzero_si128(), _mm_add_epi16(kept, strong));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(classes), _mm_packus_epi16(numbers, numbers));
}
inline void store_classes(Lanes32, __m128i kept, __m128i strong, std::uint8_t* classes) noexcept {
  const __m128i numbers = _mm_sub_epi32(_mm_setzero_si128(), _mm_add_epi32(kept, strong));
  const __m128i words = _mm_packs_epi32(numbers, numbers);
  const std::int32_t four = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
  std::memcpy(classes, &four, sizeof four);
}

/// Without an instruction that counts bits: adds up bytes of 0 and 1.
inline std::uint32_t count_of_bytes(__m128i mask) noexcept {
  const __m128i sums = _mm_sad_epu8(_mm_and_si128(mask, _mm_set1_epi8(1)), _mm_setzero_si128());
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(sums) + _mm_extract_epi16(sums, 4));
}
inline std::uint32_t count_of(Lanes16, __m128i mask) noexcept {
  return count_of_bytes(mask) / 2;
}
inline std::uint32_t count_of(Lanes32, __m128i mask) noexcept {
  return count_of_bytes(mask) / 4;
}

inline std::uint64_t bits_above(const std::uint8_t* bytes, char limit) noexcept {
  std::uint64_t bits = 0;
  for (unsigned k = 0; k < 64; k += 16) {
    const __m128i above = _mm_cmpgt_epi8(Lanes16::load(bytes + k).v, _mm_set1_epi8(limit));
    bits |= static_cast<std::uint64_t>(_mm_movemask_epi8(above)) << k;
  }
  return bits;
}

/// A bit for each of 64 bytes that are 0, 1 or 2.
inline std::uint64_t bits_above_0(const std::uint8_t* bytes) noexcept {
  return bits_above(bytes, 0);
}
inline std::uint64_t bits_above_1(const std::uint8_t* bytes) noexcept {
  return bits_above(bytes, 1);
}

/// The other way, with 255 where the bit is set.
inline void spread_bits(std::uint64_t bits, std::uint8_t* bytes) noexcept {
  const __m128i own_bit = _mm_set1_epi64x(static_cast<long long>(0x8040201008040201U));
  for (unsigned k = 0; k < 64; k += 16) {
    const __m128i two = _mm_cvtsi32_si128(static_cast<int>((bits >> k) & 0xFFFFU));
    const __m128i pairs = _mm_unpacklo_epi8(two, two), fours = _mm_unpacklo_epi16(pairs, pairs);
    const __m128i copies = _mm_unpacklo_epi32(fours, fours);
    Lanes16{_mm_cmpeq_epi8(_mm_and_si128(copies, own_bit), own_bit)}.store(bytes + k);
  }
}

inline std::uint32_t count_of(std::uint64_t bits) noexcept {
  const std::uint64_t twos = bits - ((bits >> 1U) & 0x5555555555555555U);
  const std::uint64_t fours = (twos & 0x3333333333333333U) + ((twos >> 2U) & 0x3333333333333333U);
  const std::uint64_t bytes = (fours + (fours >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::uint32_t>((bytes * 0x0101010101010101U) >> 56U);
}

/// 32-bit sums of products, one a lane of Lanes16: those of even lanes, and those of odd ones.
struct ProductSums {
  __m128i even, odd;
  static ProductSums all(std::int32_t value) noexcept {
    return {_mm_set1_epi32(value), _mm_set1_epi32(value)};
  }
  /// To lanes 2 i and 2 i + 1 the products of these two numbers with two factors each, the one of number 2 i
  /// in the low half.
  void add(Lanes16 numbers, std::int32_t to_even, std::int32_t to_odd) noexcept {
    even = _mm_add_epi32(even, _mm_madd_epi16(numbers.v, _mm_set1_epi32(to_even)));
    odd = _mm_add_epi32(odd, _mm_madd_epi16(numbers.v, _mm_set1_epi32(to_odd)));
  }
  /// The sums divided by 65536, which must fit a byte.
  void store_bytes(std::uint8_t* bytes) const noexcept {
    const __m128i numbers =
        _mm_or_si128(_mm_srli_epi32(even, 16), _mm_and_si128(odd, _mm_set1_epi32(-65536)));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(bytes), _mm_packus_epi16(numbers, numbers));
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
