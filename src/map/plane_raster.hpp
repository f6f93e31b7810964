// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_extent.hpp"

namespace straightedge {

/// A binary picture of a part of a plane, a bit a cell. Cell (x, y) covers [x, x + 1] · cell from the origin
/// on, its rim is never covered.
struct Raster {
  PlanePoint origin;
  double cell = 0;
  std::int32_t width = 0, height = 0;
  std::size_t pitch = 0;             ///< words of a row
  std::vector<std::uint64_t> words;  ///< row by row; bits beyond the width are 0

  Raster() = default;
  Raster(std::int32_t columns, std::int32_t rows);

  std::uint64_t* row(std::int32_t y) { return words.data() + static_cast<std::size_t>(y) * pitch; }
  const std::uint64_t* row(std::int32_t y) const {
    return words.data() + static_cast<std::size_t>(y) * pitch;
  }
  bool covered(std::int32_t x, std::int32_t y) const {
    return (row(y)[x / 64] >> (static_cast<unsigned>(x) % 64) & 1U) != 0;
  }
  /// Covers the cells from begin to end of row y, or uncovers them.
  void set(std::int32_t y, std::int32_t begin, std::int32_t end, bool value) {
    std::uint64_t* const words_of_row = row(y);
    for (; begin < end; begin = begin / 64 * 64 + 64) {
      // Of the word: from `begin` on, without those beyond the end.
      std::uint64_t bits = ~std::uint64_t{0} << (static_cast<std::uint32_t>(begin) % 64);
      if (end < begin / 64 * 64 + 64) bits &= ~(~std::uint64_t{0} << (static_cast<std::uint32_t>(end) % 64));
      std::uint64_t& word = words_of_row[begin / 64];
      word = value ? word | bits : word & ~bits;
    }
  }
};

/// Empty, with room for the pieces and `margin` metres around them. At most 2^24 cells: they grow by powers
/// of two where that is too few.
Raster raster_for(std::span<const ExtentPiece> pieces, double cell, double margin);

void paint(Raster& raster, const ExtentPiece& piece);

/// The inside of borders taken together: a cell is inside when a ray from its middle crosses them an odd
/// number of times.
void paint(Raster& raster, std::span<const ExtentLoop> loops);

/// Step 3 of extent_loops.
void close_gaps(Raster& raster, double max_gap);

/// Step 4. Islands hang together by sides, holes by corners too.
void fill_holes(Raster& raster, double max_hole);
void drop_islands(Raster& raster, double min_area);

/// Step 5: the corners of every border, in cells.
struct CellLoop {
  std::vector<std::int32_t> x, y;
};
std::vector<CellLoop> cell_borders(const Raster& raster);

}  // namespace straightedge
