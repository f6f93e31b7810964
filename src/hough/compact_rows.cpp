// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/compact_rows.hpp"

#include "hough/cells.hpp"

namespace straightedge::hough {
namespace {

template <class Cell>
HoughCandidate cast(Cell* cells, const HoughMemory& memory, PixelPlace pixel, Angles angles,
                    HoughCandidate best) noexcept {
  const auto x = static_cast<float>(pixel.x);
  const auto y = static_cast<float>(pixel.y);
  for (std::int32_t n = angles.first; n < angles.end; ++n) {
    Cell& cell = cells[cell_index(memory, static_cast<std::size_t>(n), x, y)];
    const std::int32_t votes = cell + 1;
    cell = static_cast<Cell>(votes);
    if (votes > best.votes) best = {votes, n};
  }
  return best;
}

template <class Cell>
void take_off(Cell* cells, const HoughMemory& memory, PixelPlace pixel, Angles angles) noexcept {
  const auto x = static_cast<float>(pixel.x);
  const auto y = static_cast<float>(pixel.y);
  for (std::int32_t n = angles.first; n < angles.end; ++n) {
    Cell& cell = cells[cell_index(memory, static_cast<std::size_t>(n), x, y)];
    cell = static_cast<Cell>(cell - 1);
  }
}

}  // namespace

void lay_out_rows(HoughJob& job) noexcept {
  HoughMemory& memory = job.memory;
  std::uint32_t start = 0;
  for (std::size_t n = 0; n < memory.offsets.size(); ++n) {
    const Reach row = reach(job.edges.size(), memory.cosines[n], memory.sines[n]);
    memory.offsets[n] = start - static_cast<std::uint32_t>(row.first) - rounding_bits;
    start += static_cast<std::uint32_t>(row.last - row.first) + 1;
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
