// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/list_pixels.hpp"

#include <cstring>

#include "hough/follow_line.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::hough {
namespace {

/// Most pixels are no edges: four at a time are read as one number, which need not be aligned.
bool any_edge(const std::uint8_t* four) noexcept {
  std::uint32_t all = 0;
  std::memcpy(&all, four, sizeof all);
  return all != 0;
}

/// Calls take(x, y) for each edge pixel.
template <class Take>
void for_each_edge(GrayView edges, const Take& take) noexcept {
  for (std::int32_t y = 0; y < edges.height; ++y) {
    const std::uint8_t* row = edges.row(y);
    for (std::int32_t x = 0; x < edges.width; ++x) {
      while (x + 4 <= edges.width && !any_edge(row + x)) x += 4;
      if (x == edges.width) break;
      if (row[x] != 0) take(x, y);
    }
  }
}

/// One pixel after the other.
std::uint32_t list_plainly(HoughJob& job) noexcept {
  const PixelStates all = states(job);
  std::uint32_t count = 0;
  for (std::uint8_t& four : job.memory.mask) four = 0;
  for_each_edge(job.edges, [&](std::int32_t x, std::int32_t y) noexcept {
    all.set(x, y, PixelState::waiting);
    if (count < job.memory.points.size())
      job.memory.points[count] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    ++count;
  });
  return count;
}

/// A row's states at once, and its pixels a piece at a time.
std::uint32_t list_rows(HoughJob& job, const HoughKernels& kernels) noexcept {
  constexpr std::int32_t piece = 256;
  std::uint16_t columns[piece + 8];
  const GrayView edges = job.edges;
  const std::span<PixelPlace> points = job.memory.points;
  std::uint8_t* states = job.memory.mask.data();
  std::uint32_t count = 0;
  for (std::int32_t y = 0; y < edges.height; ++y, states += PixelStates::row_bytes(edges.width)) {
    kernels.mark_edges(edges.row(y), edges.width, states);
    for (std::int32_t first = 0; first < edges.width; first += piece) {
      const std::int32_t width = edges.width - first < piece ? edges.width - first : piece;
      const auto more =
          static_cast<std::uint32_t>(kernels.marked_columns(states + first / 4, width, columns));
      const std::size_t room = points.size() < count ? 0 : points.size() - count;
      const std::size_t written = more < room ? more : room;
      for (std::size_t i = 0; i < written; ++i)
        points[count + i] = {static_cast<std::uint16_t>(first + columns[i]), static_cast<std::uint16_t>(y)};
      count += more;
    }
  }
  return count;
}

}  // namespace

std::uint32_t list_pixels(HoughJob& job) noexcept {
  return job.options.kernels == nullptr ? list_plainly(job) : list_rows(job, *job.options.kernels);
}

}  // namespace straightedge::hough
