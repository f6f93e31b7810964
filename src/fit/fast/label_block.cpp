// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../label_block.cpp; read that first.
#include <immintrin.h>

#include "fit/pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// The readings of a row that get no label.
struct Missed {
  std::int64_t n = 0, u = 0, uu = 0;
  __m256d sums = _mm256_setzero_pd();  ///< of a reading times 1, its column, its row, itself

  /// Bit i: the one i columns right of `column`, q[i].
  void add(std::uint64_t some, const float* q, std::int32_t column, double v) noexcept {
    const __m256d by = _mm256_set_pd(0, v, 0, 1);
    for (; some != 0; some &= some - 1) {
      const std::int32_t i = __builtin_ctzll(some);
      const std::int64_t at = column + i;
      const __m256d reading = _mm256_set1_pd(static_cast<double>(q[i]));
      const __m256d placed = _mm256_blend_pd(by, _mm256_set1_pd(static_cast<double>(at)), 2);
      sums = _mm256_add_pd(sums, _mm256_mul_pd(reading, _mm256_blend_pd(placed, reading, 8)));
      n += 1;
      u += at;
      uu += at * at;
    }
  }
};

/// What label_block takes from.
struct Sums {
  double n, u, v, uu, uv, vv;
  __m256d readings;

  explicit Sums(const double* of) noexcept
      : n(of[0]), u(of[1]), v(of[2]), uu(of[3]), uv(of[4]), vv(of[5]), readings(_mm256_loadu_pd(of + 6)) {}
  void subtract(const Missed& missed, double row) noexcept {
    const auto count = static_cast<double>(missed.n), columns = static_cast<double>(missed.u);
    n -= count;
    u -= columns;
    v -= row * count;
    uu -= static_cast<double>(missed.uu);
    uv -= row * columns;
    vv -= row * row * count;
    readings = _mm256_sub_pd(readings, missed.sums);
  }
  void store(double* to) const noexcept {
    const double whole[] = {n, u, v, uu, uv, vv};
    for (int i = 0; i < 6; ++i) to[i] = whole[i];
    _mm256_storeu_pd(to + 6, readings);
  }
};

#if defined(__AVX512BW__)
constexpr std::int32_t at_once = 16;

struct Look {
  __m512 slope, limit, least, columns, first{};
  __m512i label;

  explicit Look(const DepthBlock& block) noexcept
      : slope(_mm512_set1_ps(static_cast<float>(block.along))),
        limit(_mm512_set1_ps(block.limit)),
        least(_mm512_set1_ps(-block.limit)),
        columns(_mm512_set_ps(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)),
        label(_mm512_set1_epi32(block.label)) {}
  /// The plane is `at` where columns are counted from.
  void begin(float at) noexcept { first = _mm512_set1_ps(at); }
  /// Labels pixels, `x` the first one's column; bits of those that are missed.
  std::uint32_t all(const float* q, float x, std::uint16_t* labels) const noexcept {
    const __m512 reading = _mm512_loadu_ps(q);
    const __mmask16 reads = some_of(reading), near = of_plane(reading, reads, x);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(labels), labels_where(near));
    return static_cast<std::uint32_t>(reads) & ~static_cast<std::uint32_t>(near);
  }
  /// The same for fewer.
  std::uint32_t first_of(const float* q, float x, std::int32_t count, std::uint16_t* labels) const noexcept {
    const auto some = static_cast<__mmask16>((1U << static_cast<std::uint32_t>(count)) - 1U);
    const __m512 reading = _mm512_maskz_loadu_ps(some, q);
    const __mmask16 reads = some_of(reading), near = of_plane(reading, reads, x);
    _mm256_mask_storeu_epi16(labels, some, labels_where(near));
    return static_cast<std::uint32_t>(reads) & ~static_cast<std::uint32_t>(near);
  }

 private:
  static __mmask16 some_of(__m512 reading) noexcept {
    return _mm512_cmp_ps_mask(reading, _mm512_setzero_ps(), _CMP_GT_OQ);
  }
  __mmask16 of_plane(__m512 reading, __mmask16 reads, float x) const noexcept {
    const __m512 column = _mm512_add_ps(columns, _mm512_set1_ps(x));
    const __m512 r = _mm512_sub_ps(reading, _mm512_add_ps(first, _mm512_mul_ps(slope, column)));
    const __mmask16 below = _mm512_mask_cmp_ps_mask(reads, r, limit, _CMP_LT_OQ);
    return _mm512_mask_cmp_ps_mask(below, r, least, _CMP_GT_OQ);
  }
  __m256i labels_where(__mmask16 near) const noexcept {
    return _mm512_cvtepi32_epi16(_mm512_maskz_mov_epi32(near, label));
  }
};
#else
constexpr std::int32_t at_once = 8;

struct Look {
  __m256 slope, limit, least, columns, first{};
  __m256i label;

  explicit Look(const DepthBlock& block) noexcept
      : slope(_mm256_set1_ps(static_cast<float>(block.along))),
        limit(_mm256_set1_ps(block.limit)),
        least(_mm256_set1_ps(-block.limit)),
        columns(_mm256_set_ps(7, 6, 5, 4, 3, 2, 1, 0)),
        label(_mm256_set1_epi32(block.label)) {}
  /// The plane is `at` where columns are counted from.
  void begin(float at) noexcept { first = _mm256_set1_ps(at); }
  /// Labels pixels, `x` the first one's column; bits of those that are missed.
  std::uint32_t all(const float* q, float x, std::uint16_t* labels) const noexcept {
    const __m256 reading = _mm256_loadu_ps(q);
    const __m256 column = _mm256_add_ps(columns, _mm256_set1_ps(x));
    const __m256 r = _mm256_sub_ps(reading, _mm256_add_ps(first, _mm256_mul_ps(slope, column)));
    const __m256 reads = _mm256_cmp_ps(reading, _mm256_setzero_ps(), _CMP_GT_OQ);
    const __m256 inside =
        _mm256_and_ps(_mm256_cmp_ps(r, limit, _CMP_LT_OQ), _mm256_cmp_ps(r, least, _CMP_GT_OQ));
    const __m256i found = _mm256_and_si256(_mm256_castps_si256(_mm256_and_ps(inside, reads)), label);
    const __m128i narrow =
        _mm_packus_epi32(_mm256_castsi256_si128(found), _mm256_extracti128_si256(found, 1));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(labels), narrow);
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_andnot_ps(inside, reads)));
  }
  /// The same for fewer.
  std::uint32_t first_of(const float* q, float x, std::int32_t count, std::uint16_t* labels) const noexcept {
    float readings[at_once] = {};
    std::uint16_t found[at_once];
    for (std::int32_t i = 0; i < count; ++i) readings[i] = q[i];
    const std::uint32_t missed = all(readings, x, found);
    for (std::int32_t i = 0; i < count; ++i) labels[i] = found[i];
    return missed;
  }
};
#endif

constexpr std::int32_t bits = 64;

/// Labels up to 64 pixels from column `left` on; bits of those that are missed.
std::uint64_t label_some(const Look& look, const float* q, std::int32_t left, std::int32_t count,
                         std::uint16_t* labels) noexcept {
  std::uint64_t missed = 0;
  std::int32_t x = 0;
  for (; x + at_once <= count; x += at_once) {
    missed |= std::uint64_t{look.all(q + x, static_cast<float>(left + x), labels + x)} << x;
  }
  if (x < count) {
    missed |= std::uint64_t{look.first_of(q + x, static_cast<float>(left + x), count - x, labels + x)} << x;
  }
  return missed;
}

}  // namespace

void label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride,
                 double* sums) noexcept {
  // Labels might be the block, for all the compiler knows.
  const DepthBlock b = block;
  Look look(b);
  Sums left(sums);
  const float* q = b.rows.first;
  for (std::int32_t y = 0; y < b.height; ++y, labels += stride, q += b.rows.stride) {
    look.begin(static_cast<float>(b.at + b.down * y));
    Missed missed;
    const double v = b.top + y;
    for (std::int32_t x = 0; x < b.width; x += bits) {
      const std::int32_t count = b.width - x < bits ? b.width - x : bits;
      const std::uint64_t some = label_some(look, q + x, x, count, labels + x);
      if (some != 0) missed.add(some, q + x, b.left + x, v);
    }
    if (missed.n > 0) left.subtract(missed, v);
  }
  left.store(sums);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
