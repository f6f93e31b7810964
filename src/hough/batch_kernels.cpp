// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "base/kernel_set.hpp"
#include "hough/part_kernels.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr float rounding = 12582912.0F;  // 1.5 * 2^23
constexpr std::int32_t room = hough_batch_room;
constexpr std::int32_t vector = 16;
constexpr std::int32_t unrolled = 4;
constexpr std::int32_t block = 64;  // angles that are looked at together

/// Where the first `count` pixels of the batch, whole vectors of them, vote at one angle.
inline void find_cells(const HoughRows& rows, std::int32_t n, const HoughBatch& batch, std::int32_t count,
                       std::uint32_t* __restrict index) noexcept {
  const float cosine = rows.cosines[n];
  const float sine = rows.sines[n];
  const std::uint32_t offset = rows.offsets[n];
  for (std::int32_t i = 0; i < count; ++i) {
    const float sum = batch.x[i] * cosine + batch.y[i] * sine + rounding;
    index[i] = __builtin_bit_cast(std::uint32_t, sum) + offset;
  }
}

/// A pixel sees more votes at angle n than at those before it.
inline void keep_most(HoughSeen& seen, std::int32_t i, std::int32_t votes, std::int32_t n) noexcept {
  if (votes <= seen.votes[i]) return;
  seen.votes[i] = static_cast<std::int16_t>(votes);
  seen.angles[i] = static_cast<std::uint16_t>(n);
}

/// One more vote in each of the cells. Few are that full that somebody has to keep how many there are, and to
/// write that down for all takes as long as voting. By fours, since not every compiler unrolls loops by
/// itself.
template <class Cell>
inline void cast_row(Cell* cells, const std::uint32_t* index, std::int32_t count, std::int32_t threshold,
                     std::int32_t n, HoughSeen& seen) noexcept {
  const auto cast_one = [&](std::int32_t i) noexcept {
    const std::int32_t votes = cells[index[i]] + 1;
    cells[index[i]] = static_cast<Cell>(votes);
    if (votes >= threshold) [[unlikely]]
      keep_most(seen, i, votes, n);
  };
  std::int32_t i = 0;
  for (; i + unrolled <= count; i += unrolled)
    for (std::int32_t k = 0; k < unrolled; ++k) cast_one(i + k);
  for (; i < count; ++i) cast_one(i);
}

template <class Cell>
inline void take_row_off(Cell* cells, const std::uint32_t* index, std::int32_t count) noexcept {
  const auto take_one = [&](std::int32_t i) noexcept {
    cells[index[i]] = static_cast<Cell>(cells[index[i]] - 1);
  };
  std::int32_t i = 0;
  for (; i + unrolled <= count; i += unrolled)
    for (std::int32_t k = 0; k < unrolled; ++k) take_one(i + k);
  for (; i < count; ++i) take_one(i);
}

template <class Cell>
void cast(Cell* cells, const HoughRows& rows, const HoughBatch& batch, std::int32_t threshold,
          HoughSeen& seen) noexcept {
  std::uint32_t index[room];
  const std::int32_t count = batch.count;
  for (std::int32_t i = 0; i < room; ++i) seen.votes[i] = 0;
  for (std::int32_t n = 0; n < rows.angles; ++n) {
    find_cells(rows, n, batch, room, index);
    cast_row(cells, index, count, threshold, n, seen);
  }
}

template <class Cell>
void take_off(Cell* cells, const HoughRows& rows, const HoughBatch& batch) noexcept {
  std::uint32_t index[room];
  const std::int32_t count = (batch.count + vector - 1) / vector * vector;
  for (std::int32_t n = 0; n < rows.angles; ++n) {
    find_cells(rows, n, batch, count, index);
    take_row_off(cells, index, batch.count);
  }
}

/// How many of the batch's pixels from number `first` on have the same sum at an angle.
inline std::int32_t count_same(float cosine, float sine, float sum, const HoughBatch& batch,
                               std::int32_t first) noexcept {
  std::int32_t same = 0;
  for (std::int32_t i = first; i < batch.count; ++i)
    same += batch.x[i] * cosine + batch.y[i] * sine + rounding == sum ? 1 : 0;
  return same;
}

/// The votes in the cell of a pixel at angle n, when it is its turn.
template <class Cell>
inline std::int32_t votes_in_turn(const Cell* cells, const HoughRows& rows, const HoughTurn& turn,
                                  std::int32_t n) noexcept {
  const float cosine = rows.cosines[n], sine = rows.sines[n];
  const float sum = turn.voting->x[turn.at] * cosine + turn.voting->y[turn.at] * sine + rounding;
  return cells[__builtin_bit_cast(std::uint32_t, sum) + rows.offsets[n]] -
         count_same(cosine, sine, sum, *turn.voting, turn.at + 1) -
         count_same(cosine, sine, sum, *turn.leaving, 0);
}

template <class Cell>
HoughCandidate find(const Cell* cells, const HoughRows& rows, const HoughTurn& turn, HoughCandidate seen,
                    std::int32_t threshold) noexcept {
  // Other cells had fewer votes, or not more and come later; and there are none that have got more.
  if (votes_in_turn(cells, rows, turn, seen.angle) == seen.votes) return seen;
  HoughCandidate best{threshold - 1, -1};
  const float x = turn.voting->x[turn.at], y = turn.voting->y[turn.at];
  std::uint32_t index[block];
  for (std::int32_t first = 0; first < rows.angles; first += block) {
    const std::int32_t angles = rows.angles - first < block ? rows.angles - first : block;
    for (std::int32_t k = 0; k < angles; ++k) {
      const float sum = x * rows.cosines[first + k] + y * rows.sines[first + k] + rounding;
      index[k] = __builtin_bit_cast(std::uint32_t, sum) + rows.offsets[first + k];
    }
    for (std::int32_t k = 0; k < angles; ++k) {
      if (cells[index[k]] <= best.votes) continue;
      const std::int32_t votes = votes_in_turn(cells, rows, turn, first + k);
      if (votes > best.votes) best = {votes, first + k};
    }
  }
  return best;
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const HoughKernels STRAIGHTEDGE_OF_SET(_hough_kernels){
    .bytes = {&STRAIGHTEDGE_KERNEL_SET::cast<std::uint8_t>, &STRAIGHTEDGE_KERNEL_SET::take_off<std::uint8_t>,
              &STRAIGHTEDGE_KERNEL_SET::find<std::uint8_t>, &STRAIGHTEDGE_KERNEL_SET::cast_in_windows,
              &STRAIGHTEDGE_KERNEL_SET::take_off_in_windows},
    .words = {&STRAIGHTEDGE_KERNEL_SET::cast<std::int16_t>, &STRAIGHTEDGE_KERNEL_SET::take_off<std::int16_t>,
              &STRAIGHTEDGE_KERNEL_SET::find<std::int16_t>, &STRAIGHTEDGE_KERNEL_SET::cast_in_windows,
              &STRAIGHTEDGE_KERNEL_SET::take_off_in_windows},
    .mark_edges = &STRAIGHTEDGE_KERNEL_SET::mark_edges,
    .marked_columns = &STRAIGHTEDGE_KERNEL_SET::marked_columns,
    .edge_columns = &STRAIGHTEDGE_KERNEL_SET::edge_columns,
    .first_angles = &STRAIGHTEDGE_KERNEL_SET::first_angles,
};

}  // namespace straightedge
