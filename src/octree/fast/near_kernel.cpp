// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../near_kernel.cpp; read that first.
#include "octree/near_kernel.hpp"

#include <immintrin.h>

#include <limits>

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::uint32_t block_words = 16;

/// Four coordinates of each of two blocks.
__m256 two_of(const std::uint32_t* first, const std::uint32_t* second) noexcept {
  const __m128 low = _mm_loadu_ps(reinterpret_cast<const float*>(first)),
               high = _mm_loadu_ps(reinterpret_cast<const float*>(second));
  return _mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
}

float least_of(__m256 v) noexcept {
  const __m128 four = _mm_min_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
}

}  // namespace

std::uint64_t find_near(const OctreeNearTask& task) noexcept {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const __m256 x = _mm256_set1_ps(task.x), y = _mm256_set1_ps(task.y), z = _mm256_set1_ps(task.z);
  __m256 squares[OctreeNearTask::most_blocks / 2];
  __m256 nearest = _mm256_set1_ps(infinity);
  for (std::uint32_t i = 0; i < task.count; i += 2) {
    const std::uint32_t* first = task.blocks + block_words * i;
    // Behind the last block there may be none: then it is the last one twice.
    const std::uint32_t* second = i + 1 < task.count ? first + block_words : first;
    const __m256 dx = _mm256_sub_ps(two_of(first, second), x);
    const __m256 dy = _mm256_sub_ps(two_of(first + 4, second + 4), y);
    const __m256 dz = _mm256_sub_ps(two_of(first + 8, second + 8), z);
    const __m256 here =
        _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy)), _mm256_mul_ps(dz, dz));
    squares[i / 2] = here;
    nearest = _mm256_min_ps(here, nearest);
  }
  const float least = least_of(nearest);
  if (least > task.limit) return 0;
  const __m256 limit = _mm256_set1_ps(near_limit(task, least));
  std::uint64_t bits = 0;
  for (std::uint32_t i = 0; i < task.count; i += 2) {
    const int near = _mm256_movemask_ps(_mm256_cmp_ps(squares[i / 2], limit, _CMP_LE_OQ));
    bits |= static_cast<std::uint64_t>(near) << (4 * i);
  }
  return bits & (UINT64_MAX >> (64 - 4 * task.count));
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
