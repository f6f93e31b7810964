// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../add_square.cpp; read that first.
#include <immintrin.h>

#include "fit/pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Terms of a pixel, 1, u, v, uu, uv, vv, q, uq, vq, qq, as products; those with q get it last.
#if defined(__AVX512F__)
struct Terms {
  __m512d a, b;  ///< 1 u v u u v 1 u by 1 1 1 u v v q q
  __m128d c;     ///< v by q; q by itself

  Terms(double u, double v) noexcept
      : a(_mm512_set_pd(u, 1, v, u, u, v, u, 1)),
        b(_mm512_set_pd(0, 0, v, v, u, 1, 1, 1)),
        c(_mm_set1_pd(v)) {}
  void move_right() noexcept {
    a = _mm512_add_pd(a, _mm512_set_pd(1, 0, 0, 1, 1, 0, 1, 0));
    b = _mm512_add_pd(b, _mm512_set_pd(0, 0, 0, 0, 1, 0, 0, 0));
  }
};

struct Sums {
  __m512d most;
  __m128d last;

  explicit Sums(const double* sums) noexcept : most(_mm512_loadu_pd(sums)), last(_mm_loadu_pd(sums + 8)) {}
  void store(double* sums) const noexcept {
    _mm512_storeu_pd(sums, most);
    _mm_storeu_pd(sums + 8, last);
  }
  /// `mark`: all bits, or none.
  void add(const Terms& t, double q, std::int64_t mark) noexcept {
    const __m128d reading = _mm_set1_pd(q), lower = _mm_mul_pd(_mm_blend_pd(t.c, reading, 2), reading);
    const __m512d upper = _mm512_mul_pd(t.a, _mm512_mask_broadcastsd_pd(t.b, 0xC0, reading));
    most = _mm512_add_pd(most, _mm512_and_pd(upper, _mm512_castsi512_pd(_mm512_set1_epi64(mark))));
    last = _mm_add_pd(last, _mm_and_pd(lower, _mm_castsi128_pd(_mm_set1_epi64x(mark))));
  }
};
#else
struct Terms {
  __m256d a, b;  ///< 1 u v u by 1 1 1 u
  __m256d c, d;  ///< u v 1 u by v v q q
  __m128d e;     ///< v by q; q by itself

  Terms(double u, double v) noexcept
      : a(_mm256_set_pd(u, v, u, 1)),
        b(_mm256_set_pd(u, 1, 1, 1)),
        c(_mm256_set_pd(u, 1, v, u)),
        d(_mm256_set1_pd(v)),
        e(_mm_set1_pd(v)) {}
  void move_right() noexcept {
    a = _mm256_add_pd(a, _mm256_set_pd(1, 0, 1, 0));
    b = _mm256_add_pd(b, _mm256_set_pd(1, 0, 0, 0));
    c = _mm256_add_pd(c, _mm256_set_pd(1, 0, 0, 1));
  }
};

struct Sums {
  __m256d first, second;
  __m128d last;

  explicit Sums(const double* sums) noexcept
      : first(_mm256_loadu_pd(sums)), second(_mm256_loadu_pd(sums + 4)), last(_mm_loadu_pd(sums + 8)) {}
  void store(double* sums) const noexcept {
    _mm256_storeu_pd(sums, first);
    _mm256_storeu_pd(sums + 4, second);
    _mm_storeu_pd(sums + 8, last);
  }
  /// `mark`: all bits, or none.
  void add(const Terms& t, double q, std::int64_t mark) noexcept {
    const __m256d reading = _mm256_set1_pd(q), marks = _mm256_castsi256_pd(_mm256_set1_epi64x(mark));
    const __m128d two = _mm256_castpd256_pd128(reading), lower = _mm_mul_pd(_mm_blend_pd(t.e, two, 2), two);
    first = _mm256_add_pd(first, _mm256_and_pd(_mm256_mul_pd(t.a, t.b), marks));
    second =
        _mm256_add_pd(second, _mm256_and_pd(_mm256_mul_pd(t.c, _mm256_blend_pd(t.d, reading, 12)), marks));
    last = _mm_add_pd(last, _mm_and_pd(lower, _mm256_castpd256_pd128(marks)));
  }
};
#endif

/// Sixteen labels.
struct Labels {
  __m256i all;

  explicit Labels(const std::uint16_t* labels) noexcept
      : all(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(labels))) {}
  /// Bits of those that are this one.
  std::uint32_t equal(std::uint16_t label) const noexcept {
    const __m256i same = _mm256_cmpeq_epi16(all, _mm256_set1_epi16(static_cast<std::int16_t>(label)));
    const __m128i bytes = _mm_packs_epi16(_mm256_castsi256_si128(same), _mm256_extracti128_si256(same, 1));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(bytes));
  }
};

}  // namespace

void add_square(const DepthRows& corner, std::int32_t left, std::int32_t top, const std::uint16_t* labels,
                double* sums) noexcept {
  const Labels of(labels);
  std::uint32_t open = ~of.equal(0) & 0xFFFFU;
  while (open != 0) {
    const std::uint16_t label = labels[__builtin_ctz(open)];
    std::uint32_t some = of.equal(label);
    open &= ~some;
    // What is not the label's adds 0, which changes nothing.
    double* of_label = sums + 10 * (label - 1);
    Sums sum(of_label);
    const float* row = corner.first;
    for (std::int32_t y = 0; y < DepthChoice::side; ++y, row += corner.stride) {
      Terms terms(left, top + y);
      for (std::int32_t x = 0; x < DepthChoice::side; ++x, some >>= 1U) {
        sum.add(terms, static_cast<double>(row[x]), -static_cast<std::int64_t>(some & 1U));
        terms.move_right();
      }
    }
    sum.store(of_label);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
