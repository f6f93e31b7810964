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

/// What the pixels have seen up to angle n.
inline void keep_most(const std::int16_t* __restrict votes, std::int32_t n, HoughSeen& seen) noexcept {
  const auto angle = static_cast<std::uint16_t>(n);
  for (std::int32_t i = 0; i < room; ++i) {
    const bool more = votes[i] > seen.votes[i];
    seen.votes[i] = more ? votes[i] : seen.votes[i];
    seen.angles[i] = more ? angle : seen.angles[i];
  }
}

/// One more vote in each of the cells, and how many there are then. By fours, since not every compiler
/// unrolls loops by itself.
template <class Cell>
inline void cast_row(Cell* cells, const std::uint32_t* index, std::int32_t count,
                     std::int16_t* votes) noexcept {
  const auto cast_one = [&](std::int32_t i) noexcept {
    Cell& cell = cells[index[i]];
    cell = static_cast<Cell>(cell + 1);
    votes[i] = static_cast<std::int16_t>(cell);
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
void cast(Cell* cells, const HoughRows& rows, const HoughBatch& batch, HoughSeen& seen) noexcept {
  // The votes of one angle are compared while those of the next are cast: reading at once, in wide
  // words, what was just written in narrow ones would have to wait.
  std::uint32_t index[room];
  std::int16_t votes[2][room] = {};
  const std::int32_t count = batch.count;
  for (std::int32_t i = 0; i < room; ++i) seen.votes[i] = 0;
  for (std::int32_t n = 0; n < rows.angles; ++n) {
    find_cells(rows, n, batch, room, index);
    cast_row(cells, index, count, votes[n & 1]);
    if (n > 0) keep_most(votes[(n & 1) ^ 1], n - 1, seen);
  }
  keep_most(votes[(rows.angles & 1) ^ 1], rows.angles - 1, seen);
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

/// How many of the pixels behind `at` vote for the same cell as it does.
inline std::int32_t count_later(float cosine, float sine, const HoughBatch& batch, std::int32_t at) noexcept {
  const float own = batch.x[at] * cosine + batch.y[at] * sine + rounding;
  std::int32_t later = 0;
  for (std::int32_t i = at + 1; i < batch.count; ++i)
    later += batch.x[i] * cosine + batch.y[i] * sine + rounding == own ? 1 : 0;
  return later;
}

/// The votes in the cell of pixel `at` at angle n, without those of the pixels behind it.
template <class Cell>
inline std::int32_t votes_in_turn(const Cell* cells, const HoughRows& rows, const HoughBatch& batch,
                                  std::int32_t at, std::int32_t n) noexcept {
  const float sum = batch.x[at] * rows.cosines[n] + batch.y[at] * rows.sines[n] + rounding;
  return cells[__builtin_bit_cast(std::uint32_t, sum) + rows.offsets[n]] -
         count_later(rows.cosines[n], rows.sines[n], batch, at);
}

template <class Cell>
HoughCandidate find(const Cell* cells, const HoughRows& rows, const HoughBatch& batch, std::int32_t at,
                    HoughCandidate seen, std::int32_t threshold) noexcept {
  // Other cells had fewer votes, or not more and come later; and there are none that have got more.
  if (votes_in_turn(cells, rows, batch, at, seen.angle) == seen.votes) return seen;
  HoughCandidate best{threshold - 1, -1};
  std::uint32_t index[block];
  for (std::int32_t first = 0; first < rows.angles; first += block) {
    const std::int32_t angles = rows.angles - first < block ? rows.angles - first : block;
    for (std::int32_t k = 0; k < angles; ++k) {
      const float sum =
          batch.x[at] * rows.cosines[first + k] + batch.y[at] * rows.sines[first + k] + rounding;
      index[k] = __builtin_bit_cast(std::uint32_t, sum) + rows.offsets[first + k];
    }
    for (std::int32_t k = 0; k < angles; ++k) {
      if (cells[index[k]] <= best.votes) continue;
      const std::int32_t votes = votes_in_turn(cells, rows, batch, at, first + k);
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
