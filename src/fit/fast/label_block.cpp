// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../label_block.cpp; read that first.
#include <immintrin.h>

#include "fit/pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// The readings of a row that get no label.
struct Missed {
  __m256d by;  ///< 1, column, row: what readings are multiplied by; last the reading itself
  std::int64_t n = 0, u = 0, uu = 0;
  __m256d sums = _mm256_setzero_pd();

  explicit Missed(std::int32_t row) noexcept : by(_mm256_set_pd(0, row, 0, 1)) {}
  /// Bit i: the one i columns right of `column`, q[i].
  void add(std::uint64_t some, const float* q, std::int32_t column) noexcept {
    for (; some != 0; some &= some - 1) {
      const std::int32_t i = __builtin_ctzll(some);
      const std::int64_t at = column + i;
      const __m256d reading = _mm256_set1_pd(static_cast<double>(q[i]));
      by = _mm256_blend_pd(by, _mm256_set1_pd(static_cast<double>(at)), 2);
      sums = _mm256_add_pd(sums, _mm256_mul_pd(reading, _mm256_blend_pd(by, reading, 8)));
      n += 1;
      u += at;
      uu += at * at;
    }
  }
  void leave(double v, double* of) const noexcept {
    const auto count = static_cast<double>(n), columns = static_cast<double>(u);
    const double whole[] = {count, columns, v * count, static_cast<double>(uu), v * columns, v * v * count};
    for (int i = 0; i < 6; ++i) of[i] -= whole[i];
    _mm256_storeu_pd(of + 6, _mm256_sub_pd(_mm256_loadu_pd(of + 6), sums));
  }
};

#if defined(__AVX512BW__)
constexpr std::int32_t at_once = 16;

struct Row {
  __m512 first, slope, limit, columns;
  __m512i label;

  Row(const DepthBlock& block, float at) noexcept
      : first(_mm512_set1_ps(at)),
        slope(_mm512_set1_ps(static_cast<float>(block.along))),
        limit(_mm512_set1_ps(block.limit)),
        columns(_mm512_set_ps(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)),
        label(_mm512_set1_epi32(block.label)) {}
  /// Labels pixels; bits of those that are missed.
  std::uint32_t all(const float* q, std::uint16_t* labels) noexcept {
    const __m512 reading = _mm512_loadu_ps(q);
    const __mmask16 reads = some_of(reading), near = of_plane(reading, reads);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(labels), labels_where(near));
    return static_cast<std::uint32_t>(reads) & ~static_cast<std::uint32_t>(near);
  }
  /// The same for fewer.
  std::uint32_t first_of(const float* q, std::int32_t count, std::uint16_t* labels) noexcept {
    const auto some = static_cast<__mmask16>((1U << static_cast<std::uint32_t>(count)) - 1U);
    const __m512 reading = _mm512_maskz_loadu_ps(some, q);
    const __mmask16 reads = some_of(reading), near = of_plane(reading, reads);
    _mm256_mask_storeu_epi16(labels, some, labels_where(near));
    return static_cast<std::uint32_t>(reads) & ~static_cast<std::uint32_t>(near);
  }

 private:
  static __mmask16 some_of(__m512 reading) noexcept {
    return _mm512_cmp_ps_mask(reading, _mm512_setzero_ps(), _CMP_GT_OQ);
  }
  __mmask16 of_plane(__m512 reading, __mmask16 reads) noexcept {
    const __m512 r = _mm512_sub_ps(reading, _mm512_add_ps(first, _mm512_mul_ps(slope, columns)));
    columns = _mm512_add_ps(columns, _mm512_set1_ps(at_once));
    const __mmask16 below = _mm512_mask_cmp_ps_mask(reads, r, limit, _CMP_LT_OQ);
    return _mm512_mask_cmp_ps_mask(below, r, _mm512_sub_ps(_mm512_setzero_ps(), limit), _CMP_GT_OQ);
  }
  __m256i labels_where(__mmask16 near) const noexcept {
    return _mm512_cvtepi32_epi16(_mm512_maskz_mov_epi32(near, label));
  }
};
#else
constexpr std::int32_t at_once = 8;

struct Row {
  __m256 first, slope, limit, columns;
  __m256i label;

  Row(const DepthBlock& block, float at) noexcept
      : first(_mm256_set1_ps(at)),
        slope(_mm256_set1_ps(static_cast<float>(block.along))),
        limit(_mm256_set1_ps(block.limit)),
        columns(_mm256_set_ps(7, 6, 5, 4, 3, 2, 1, 0)),
        label(_mm256_set1_epi32(block.label)) {}
  /// Labels pixels; bits of those that are missed.
  std::uint32_t all(const float* q, std::uint16_t* labels) noexcept {
    const __m256 reading = _mm256_loadu_ps(q);
    const __m256 r = _mm256_sub_ps(reading, _mm256_add_ps(first, _mm256_mul_ps(slope, columns)));
    columns = _mm256_add_ps(columns, _mm256_set1_ps(at_once));
    const __m256 reads = _mm256_cmp_ps(reading, _mm256_setzero_ps(), _CMP_GT_OQ);
    const __m256 inside =
        _mm256_and_ps(_mm256_cmp_ps(r, limit, _CMP_LT_OQ),
                      _mm256_cmp_ps(r, _mm256_sub_ps(_mm256_setzero_ps(), limit), _CMP_GT_OQ));
    const __m256i found = _mm256_and_si256(_mm256_castps_si256(_mm256_and_ps(inside, reads)), label);
    const __m128i narrow =
        _mm_packus_epi32(_mm256_castsi256_si128(found), _mm256_extracti128_si256(found, 1));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(labels), narrow);
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_andnot_ps(inside, reads)));
  }
  /// The same for fewer.
  std::uint32_t first_of(const float* q, std::int32_t count, std::uint16_t* labels) noexcept {
    float readings[at_once] = {};
    std::uint16_t found[at_once];
    for (std::int32_t i = 0; i < count; ++i) readings[i] = q[i];
    const std::uint32_t missed = all(readings, found);
    for (std::int32_t i = 0; i < count; ++i) labels[i] = found[i];
    return missed;
  }
};
#endif

constexpr std::int32_t bits = 64;

/// Labels up to 64 pixels; bits of those that are missed.
std::uint64_t label_some(Row& row, const float* q, std::int32_t count, std::uint16_t* labels) noexcept {
  std::uint64_t missed = 0;
  std::int32_t x = 0;
  for (; x + at_once <= count; x += at_once) missed |= std::uint64_t{row.all(q + x, labels + x)} << x;
  if (x < count) missed |= std::uint64_t{row.first_of(q + x, count - x, labels + x)} << x;
  return missed;
}

}  // namespace

void label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride,
                 double* sums) noexcept {
  const std::int32_t width = block.width;
  for (std::int32_t y = 0; y < block.height; ++y, labels += stride) {
    const float* q = block.rows.first + y * block.rows.stride;
    Row row(block, static_cast<float>(block.at + block.down * y));
    Missed missed(block.top + y);
    for (std::int32_t x = 0; x < width; x += bits) {
      const std::int32_t count = width - x < bits ? width - x : bits;
      missed.add(label_some(row, q + x, count, labels + x), q + x, block.left + x);
    }
    if (missed.n > 0) missed.leave(block.top + y, sums);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
