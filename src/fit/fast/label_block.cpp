// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../label_block.cpp; read that first.
#include <immintrin.h>

#include "fit/pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Multiples of the slope, for the columns of a block.
struct Slopes {
  alignas(64) float along[DepthBlock::widest];

  Slopes(float slope, std::int32_t width) noexcept {
    for (std::int32_t first = 0; first < width; first += 16) {
      for (std::int32_t x = first; x < first + 16; ++x) along[x] = slope * static_cast<float>(x);
    }
  }
};

#if defined(__AVX512BW__)
constexpr std::int32_t at_once = 32;

struct Look {
  __m512 limit, first{};
  __m512i label;

  explicit Look(const DepthBlock& block) noexcept
      : limit(_mm512_set1_ps(block.limit)),
        label(_mm512_set1_epi16(static_cast<std::int16_t>(block.label))) {}
  /// The plane is `at` in column 0.
  void begin(float at) noexcept { first = _mm512_set1_ps(at); }
  /// Labels pixels; how many are the plane's.
  std::int32_t all(const float* q, const float* along, std::uint16_t* labels) const noexcept {
    const __mmask16 left = look(_mm512_loadu_ps(q), along), right = look(_mm512_loadu_ps(q + 16), along + 16);
    const __mmask32 near = _mm512_kunpackw(right, left);
    _mm512_storeu_si512(labels, _mm512_maskz_mov_epi16(near, label));
    return __builtin_popcount(_cvtmask32_u32(near));
  }
  /// The same for fewer.
  std::int32_t first_of(const float* q, const float* along, std::int32_t count,
                        std::uint16_t* labels) const noexcept {
    const auto some = static_cast<__mmask32>((1ULL << static_cast<std::uint32_t>(count)) - 1U);
    const __mmask16 left = look(_mm512_maskz_loadu_ps(static_cast<__mmask16>(some), q), along),
                    right =
                        look(_mm512_maskz_loadu_ps(static_cast<__mmask16>(some >> 16U), q + 16), along + 16);
    const __mmask32 near = _mm512_kunpackw(right, left);
    _mm512_mask_storeu_epi16(labels, some, _mm512_maskz_mov_epi16(near, label));
    return __builtin_popcount(_cvtmask32_u32(near));
  }

 private:
  __mmask16 look(__m512 reading, const float* along) const noexcept {
    const __m512 r = _mm512_sub_ps(reading, _mm512_add_ps(first, _mm512_load_ps(along)));
    const __mmask16 reads = _mm512_cmp_ps_mask(reading, _mm512_setzero_ps(), _CMP_GT_OQ);
    return _mm512_mask_cmp_ps_mask(reads, _mm512_abs_ps(r), limit, _CMP_LT_OQ);
  }
};
#else
constexpr std::int32_t at_once = 16;

struct Look {
  __m256 limit, first{};
  __m256i label;

  explicit Look(const DepthBlock& block) noexcept
      : limit(_mm256_set1_ps(block.limit)),
        label(_mm256_set1_epi16(static_cast<std::int16_t>(block.label))) {}
  /// The plane is `at` in column 0.
  void begin(float at) noexcept { first = _mm256_set1_ps(at); }
  /// Labels pixels; how many are the plane's.
  std::int32_t all(const float* q, const float* along, std::uint16_t* labels) const noexcept {
    const __m256 left = look(q, along), right = look(q + 8, along + 8);
    const __m256i near = packed(left, right);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(labels), _mm256_and_si256(near, label));
    return __builtin_popcount(bits_of(left) | bits_of(right) << 8U);
  }
  /// The same for fewer.
  std::int32_t first_of(const float* q, const float* along, std::int32_t count,
                        std::uint16_t* labels) const noexcept {
    float readings[at_once] = {};
    std::uint16_t found[at_once];
    for (std::int32_t i = 0; i < count; ++i) readings[i] = q[i];
    const std::int32_t near = all(readings, along, found);
    for (std::int32_t i = 0; i < count; ++i) labels[i] = found[i];
    return near;
  }

 private:
  __m256 look(const float* q, const float* along) const noexcept {
    const __m256 reading = _mm256_loadu_ps(q);
    const __m256 r = _mm256_sub_ps(reading, _mm256_add_ps(first, _mm256_load_ps(along)));
    const __m256 size = _mm256_andnot_ps(_mm256_set1_ps(-0.0F), r);
    const __m256 reads = _mm256_cmp_ps(reading, _mm256_setzero_ps(), _CMP_GT_OQ);
    const __m256 inside = _mm256_cmp_ps(size, limit, _CMP_LT_OQ);
    return _mm256_and_ps(inside, reads);
  }
  static std::uint32_t bits_of(__m256 marks) noexcept {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(marks));
  }
  /// Sixteen marks of 16 bits.
  static __m256i packed(__m256 left, __m256 right) noexcept {
    const __m256i both = _mm256_packs_epi32(_mm256_castps_si256(left), _mm256_castps_si256(right));
    return _mm256_permute4x64_epi64(both, 0xD8);
  }
};
#endif

}  // namespace

std::int32_t label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept {
  // Labels might be the block, for all the compiler knows.
  const DepthBlock b = block;
  Look look(b);
  const Slopes slopes(static_cast<float>(b.along), b.width);
  const std::int32_t whole = b.width / at_once * at_once, rest = b.width - whole;
  const float* q = b.rows.first;
  std::int32_t count = 0;
  for (std::int32_t y = 0; y < b.height; ++y, labels += stride, q += b.rows.stride) {
    look.begin(static_cast<float>(b.at + b.down * y));
    for (std::int32_t x = 0; x < whole; x += at_once) count += look.all(q + x, slopes.along + x, labels + x);
    if (rest > 0) count += look.first_of(q + whole, slopes.along + whole, rest, labels + whole);
  }
  return count;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
