// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "base/kernel_set.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr float rounding = 12582912.0F;  // 1.5 * 2^23
constexpr std::int32_t room = hough_batch_room;
constexpr std::int32_t block = 64;  // angles that are looked at together

/// Where the batch votes at one angle. All of the room, so that the loop has no rest.
inline void find_cells(const HoughRows& rows, std::int32_t n, const HoughBatch& batch,
                       std::uint32_t* __restrict index) noexcept {
  const float cosine = rows.cosines[n];
  const float sine = rows.sines[n];
  const std::uint32_t offset = rows.offsets[n];
  for (std::int32_t i = 0; i < room; ++i) {
    const float sum = batch.x[i] * cosine + batch.y[i] * sine + rounding;
    index[i] = __builtin_bit_cast(std::uint32_t, sum) + offset;
  }
}

template <class Cell>
inline void keep_most(const Cell* __restrict votes, Cell* __restrict most) noexcept {
  for (std::int32_t i = 0; i < room; ++i) most[i] = most[i] < votes[i] ? votes[i] : most[i];
}

template <class Cell>
void cast(Cell* cells, const HoughRows& rows, const HoughBatch& batch, Cell* most) noexcept {
  // The votes of one angle are compared while those of the next are cast: reading at once, in wide
  // words, what was just written in narrow ones would have to wait.
  std::uint32_t index[room];
  Cell votes[2][room] = {};
  for (std::int32_t i = 0; i < room; ++i) most[i] = 0;
  for (std::int32_t n = 0; n < rows.angles; ++n) {
    find_cells(rows, n, batch, index);
    Cell* const here = votes[n & 1];
    for (std::int32_t i = 0; i < batch.count; ++i) {
      Cell& cell = cells[index[i]];
      cell = static_cast<Cell>(cell + 1);
      here[i] = cell;
    }
    keep_most(votes[(n & 1) ^ 1], most);
  }
  keep_most(votes[0], most);
  keep_most(votes[1], most);
}

template <class Cell>
void take_off(Cell* cells, const HoughRows& rows, const HoughBatch& batch) noexcept {
  std::uint32_t index[room];
  for (std::int32_t n = 0; n < rows.angles; ++n) {
    find_cells(rows, n, batch, index);
    for (std::int32_t i = 0; i < batch.count; ++i) {
      Cell& cell = cells[index[i]];
      cell = static_cast<Cell>(cell - 1);
    }
  }
}

/// For angles [first, first + block): where pixel `at` votes, and how many of those behind it vote there, too.
struct SharedCells {
  float own[block];
  std::int32_t later[block];
};

inline void find_shared(const float* __restrict cosines, const float* __restrict sines, std::int32_t angles,
                        const HoughBatch& batch, std::int32_t at, SharedCells& shared) noexcept {
  for (std::int32_t k = 0; k < angles; ++k) {
    shared.own[k] = batch.x[at] * cosines[k] + batch.y[at] * sines[k] + rounding;
    shared.later[k] = 0;
  }
  for (std::int32_t i = at + 1; i < batch.count; ++i) {
    const float x = batch.x[i];
    const float y = batch.y[i];
    for (std::int32_t k = 0; k < angles; ++k)
      shared.later[k] += x * cosines[k] + y * sines[k] + rounding == shared.own[k] ? 1 : 0;
  }
}

template <class Cell>
HoughCandidate find(const Cell* cells, const HoughRows& rows, const HoughBatch& batch, std::int32_t at,
                    HoughCandidate best) noexcept {
  SharedCells shared;
  for (std::int32_t first = 0; first < rows.angles; first += block) {
    const std::int32_t angles = rows.angles - first < block ? rows.angles - first : block;
    find_shared(rows.cosines + first, rows.sines + first, angles, batch, at, shared);
    for (std::int32_t k = 0; k < angles; ++k) {
      const std::uint32_t index =
          __builtin_bit_cast(std::uint32_t, shared.own[k]) + rows.offsets[first + k];
      const std::int32_t votes = cells[index] - shared.later[k];
      if (votes > best.votes) best = {votes, first + k};
    }
  }
  return best;
}

std::int32_t edge_columns(const std::uint8_t* row, std::int32_t width, std::uint16_t* columns) noexcept {
  constexpr std::int32_t wide = 64;
  constexpr std::int32_t narrow = 8;
  std::int32_t count = 0;
  std::int32_t x = 0;
  const auto list = [&](std::int32_t end) noexcept {
    for (; x < end; ++x) {
      columns[count] = static_cast<std::uint16_t>(x);
      count += row[x] != 0 ? 1 : 0;
    }
  };
  while (x + wide <= width) {
    std::uint8_t any = 0;
    for (std::int32_t k = 0; k < wide; ++k) any = static_cast<std::uint8_t>(any | row[x + k]);
    const std::int32_t end = x + wide;
    if (any == 0) x = end;
    while (x < end) {
      std::uint64_t eight = 0;
      __builtin_memcpy(&eight, row + x, narrow);
      if (eight == 0) {
        x += narrow;
      } else {
        list(x + narrow);
      }
    }
  }
  list(width);
  return count;
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const HoughKernels STRAIGHTEDGE_OF_SET(_hough_kernels){
    .bytes = {&STRAIGHTEDGE_KERNEL_SET::cast<std::uint8_t>, &STRAIGHTEDGE_KERNEL_SET::take_off<std::uint8_t>,
              &STRAIGHTEDGE_KERNEL_SET::find<std::uint8_t>},
    .words = {&STRAIGHTEDGE_KERNEL_SET::cast<std::int16_t>, &STRAIGHTEDGE_KERNEL_SET::take_off<std::int16_t>,
              &STRAIGHTEDGE_KERNEL_SET::find<std::int16_t>},
    .edge_columns = &STRAIGHTEDGE_KERNEL_SET::edge_columns,
};

}  // namespace straightedge
