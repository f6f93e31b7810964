// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/hough_cells.hpp"
#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_kernels.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"
#include "straightedge/pixel_states.hpp"

namespace straightedge {

/// A pixel's place in four bytes; image sides are below 2^15.
struct PixelPlace {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
};

/// What the progressive method needs to let pixels vote ahead.
struct HoughAhead {
  HoughBatch voting;
  HoughSeen seen;
  PixelPlace places[hough_batch_room];    ///< of the pixels that vote
  std::uint32_t draws[hough_batch_room];  ///< how many had been drawn with each of them
  HoughBatch leaving;                     ///< pixels whose votes come off
  PixelPlace left_behind[hough_batch_room];
  std::uint16_t voting_firsts[hough_batch_room];   ///< where their gradient windows begin
  std::uint16_t leaving_firsts[hough_batch_room];  ///< likewise
};

/// Side of the squares in which the randomized method keeps its pixels: at least the radius, so that
/// a square and its eight neighbours hold everything near. Without a radius the image is one square.
constexpr std::int32_t hough_bucket_side(Size size, const HoughOptions& options) noexcept {
  const std::int32_t longest = size.width > size.height ? size.width : size.height;
  if (options.pair_radius == 0 || options.pair_radius >= longest) return longest;
  const auto side = static_cast<std::int32_t>(options.pair_radius) + 1;
  return side < 8 ? 8 : side;
}

/// Rows of the image whose votes the standard method casts together.
inline constexpr std::int32_t hough_band_rows = 32;

/// Progressive: rows that the tables of the angles have. With kernels, windows must not be broken where they
/// cross pi: so the first angles come again behind the last.
constexpr std::size_t hough_table_rows(const HoughOptions& options, const HoughGrid& grid) noexcept {
  const auto angles = static_cast<std::size_t>(grid.angles);
  const bool progressive = options.method == HoughMethod::progressive;
  if (!progressive || options.kernels == nullptr || !(options.gradient_window > 0)) return angles;
  return angles + static_cast<std::size_t>(hough_window_angles(grid, options)) + hough_rows_more;
}

/// The workspace of the three methods; what a method does not use stays empty.
struct HoughMemory {
  std::span<std::int32_t> cells;     ///< the accumulator (standard, randomized: with its guard cells)
  std::span<std::int16_t> cells16;   ///< the same, where hough_cell_bytes says 2
  std::span<std::uint8_t> cells8;    ///< the same, where hough_cell_bytes says 1
  std::span<float> cosines;          ///< of each angle, divided by rho_step
  std::span<float> sines;            ///< likewise
  std::span<std::uint32_t> offsets;  ///< progressive: of each angle's row in the accumulator
  std::span<std::uint8_t> mask;      ///< a pixel's state, rows without gaps; progressive: two bits each
  std::span<PixelPlace> points;      ///< standard: of one band of rows; else all edge pixels
  std::span<HoughAhead> ahead;       ///< progressive: one, where there are kernels
  std::span<std::uint32_t> buckets;  ///< randomized: where each square's pixels begin in `points`

  static constexpr HoughMemory take(Arena& arena, Size size, const HoughOptions& options,
                                    const HoughGrid& grid) noexcept {
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    const auto angles = static_cast<std::size_t>(grid.angles);
    const std::size_t rows = hough_table_rows(options, grid);
    const auto distances = static_cast<std::size_t>(grid.distances);
    const bool standard = options.method == HoughMethod::standard;
    const bool progressive = options.method == HoughMethod::progressive;
    const bool randomized = options.method == HoughMethod::randomized;
    constexpr std::size_t guards = 2 * hough_guard;
    HoughMemory memory;
    if (standard) memory.cells = arena.take<std::int32_t>((angles + guards) * (distances + guards));
    if (randomized) memory.take_cells(arena, angles * distances + guards, hough_cell_bytes(size, options));
    if (progressive) {
      memory.take_cells(arena, hough_row_cells(size, grid), hough_cell_bytes(size, options));
      memory.offsets = arena.take<std::uint32_t>(rows);
      if (options.kernels != nullptr) memory.ahead = arena.take<HoughAhead>(1);
    }
    if (!randomized) {
      memory.cosines = arena.take<float>(rows);
      memory.sines = arena.take<float>(rows);
    }
    memory.mask =
        arena.take<std::uint8_t>(progressive ? PixelStates::row_bytes(size.width) * height : width * height);
    memory.points = arena.take<PixelPlace>(standard ? width * std::size_t{hough_band_rows}
                                                    : hough_edge_room(size, options));
    if (randomized) {
      const auto side = static_cast<std::size_t>(hough_bucket_side(size, options));
      memory.buckets =
          arena.take<std::uint32_t>(((width + side - 1) / side) * ((height + side - 1) / side) + 1);
    }
    return memory;
  }

 private:
  constexpr void take_cells(Arena& arena, std::size_t count, std::size_t bytes) noexcept {
    if (bytes == 1) cells8 = arena.take<std::uint8_t>(count);
    if (bytes == 2) cells16 = arena.take<std::int16_t>(count);
    if (bytes == 4) cells = arena.take<std::int32_t>(count);
  }
};

}  // namespace straightedge
