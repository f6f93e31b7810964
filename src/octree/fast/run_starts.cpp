// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../run_starts.cpp; read that first.
#include <immintrin.h>

#include "octree/run_starts.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::size_t lanes = 16;

/// Along an axis, the points `i` to `i + lanes` of a batch.
__m512i cells_at(const std::int32_t* axis, std::size_t i) noexcept {
  return _mm512_loadu_si512(axis + i + 1);
}
__m512i changes_at(const std::int32_t* axis, std::size_t i) noexcept {
  return _mm512_xor_si512(cells_at(axis, i), _mm512_loadu_si512(axis + i));
}
/// The lanes of `some` side by side, and behind them what will be written over.
void put(std::uint32_t* to, __mmask16 some, __m512i from) noexcept {
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(some, from));
}
/// Of as many lanes those below `count`.
__mmask16 below(std::size_t count) noexcept {
  return static_cast<__mmask16>(count < lanes ? (1U << count) - 1 : 0xffffU);
}

}  // namespace

void find_run_starts(const OctreeCellBatch& cells, std::size_t points, OctreeRunStarts& starts) noexcept {
  StartCells found;
  std::uint32_t count = 0;
  __m512i place = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  for (std::size_t i = 0; i < points; i += lanes) {
    const __m512i changed = _mm512_or_si512(_mm512_or_si512(changes_at(cells.x, i), changes_at(cells.y, i)),
                                            changes_at(cells.z, i));
    const __mmask16 start = _mm512_mask_test_epi32_mask(below(points - i), changed, changed);
    put(starts.at + count, start, place);
    put(found.x + count, start, cells_at(cells.x, i));
    put(found.y + count, start, cells_at(cells.y, i));
    put(found.z + count, start, cells_at(cells.z, i));
    count += static_cast<std::uint32_t>(__builtin_popcount(_cvtmask16_u32(start)));
    place = _mm512_add_epi32(place, _mm512_set1_epi32(lanes));
  }
  starts.count = count;
  note_parts(found, starts);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
