// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/compact_rows.hpp"

#include "hough/cells.hpp"

namespace straightedge::hough {
namespace {

/// Calls visit(n, cell) for the angles. The cells are found some at a time, before any of them is written: so
/// compilers can use vectors, and need not read the tables' addresses again.
template <class Cell, class Visit>
void for_cells(Cell* cells, const HoughMemory& memory, PixelPlace pixel, Angles angles,
               const Visit& visit) noexcept {
  constexpr std::int32_t some = 16;
  std::uint32_t index[some];
  const auto x = static_cast<float>(pixel.x);
  const auto y = static_cast<float>(pixel.y);
  for (std::int32_t first = angles.first; first < angles.end; first += some) {
    const float* const cosines = memory.cosines.data() + first;
    const float* const sines = memory.sines.data() + first;
    const std::uint32_t* const offsets = memory.offsets.data() + first;
    const std::int32_t count = angles.end - first < some ? angles.end - first : some;
    for (std::int32_t k = 0; k < count; ++k)
      index[k] = std::bit_cast<std::uint32_t>(x * cosines[k] + y * sines[k] + rounding_float) + offsets[k];
    for (std::int32_t k = 0; k < count; ++k) visit(first + k, cells[index[k]]);
  }
}

template <class Cell>
HoughCandidate cast(Cell* cells, const HoughMemory& memory, PixelPlace pixel, Angles angles,
                    HoughCandidate best) noexcept {
  for_cells(cells, memory, pixel, angles, [&](std::int32_t n, Cell& cell) noexcept {
    const std::int32_t votes = cell + 1;
    cell = static_cast<Cell>(votes);
    if (votes > best.votes) best = {votes, n};
  });
  return best;
}

template <class Cell>
void take_off(Cell* cells, const HoughMemory& memory, PixelPlace pixel, Angles angles) noexcept {
  for_cells(cells, memory, pixel, angles,
            [](std::int32_t, Cell& cell) noexcept { cell = static_cast<Cell>(cell - 1); });
}

}  // namespace

void lay_out_rows(HoughJob& job) noexcept {
  HoughMemory& memory = job.memory;
  std::uint32_t start = 0;
  const auto angles = static_cast<std::size_t>(job.grid.angles);
  for (std::size_t n = 0; n < angles; ++n) {
    const Reach row = reach(job.edges.size(), memory.cosines[n], memory.sines[n]);
    memory.offsets[n] = start - static_cast<std::uint32_t>(row.first) - rounding_bits;
    start += static_cast<std::uint32_t>(row.last - row.first) + 1;
  }
  for (std::size_t n = angles; n < memory.offsets.size(); ++n) {
    memory.cosines[n] = memory.cosines[n - angles];
    memory.sines[n] = memory.sines[n - angles];
    memory.offsets[n] = memory.offsets[n - angles];
  }
}

HoughCandidate cast_votes(const HoughMemory& memory, PixelPlace pixel, Angles angles,
                          HoughCandidate best) noexcept {
  return with_cells(memory, [&](auto* cells) noexcept { return cast(cells, memory, pixel, angles, best); });
}

void take_votes_off(const HoughMemory& memory, PixelPlace pixel, Angles angles) noexcept {
  with_cells(memory, [&](auto* cells) noexcept { take_off(cells, memory, pixel, angles); });
}

}  // namespace straightedge::hough
