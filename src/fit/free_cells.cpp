// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "free_cells.hpp"

#include <algorithm>

#include "undecided_cells.hpp"

namespace straightedge::detail {
namespace {

constexpr std::uint16_t taken = 0xFFFF;
constexpr std::int32_t reach = 2;

constexpr std::int32_t at_once = 16;

/// Bit i: cell i has at least so many readings.
std::uint32_t bits_of_read(const std::uint8_t* counts, std::int32_t cells, std::int32_t least) noexcept {
  std::uint32_t read = 0;
  for (std::int32_t i = 0; i < cells; ++i) read |= static_cast<std::uint32_t>(counts[i] >= least) << i;
  return read;
}

struct Grid {
  std::span<const std::uint16_t> labels;
  ImageView<std::uint16_t> marks;
  std::span<const std::uint8_t> counts;
  std::int32_t least_readings;
  Size size;

  std::size_t place(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  }
  bool is_free(std::int32_t x, std::int32_t y) const noexcept {
    return x >= 0 && x < size.width && labels[place(x, y)] == 0 && counts[place(x, y)] >= least_readings;
  }
  /// Bit i: cell (x + i, y) is free, of sixteen.
  std::uint32_t free_from(std::int32_t x, std::int32_t y) const noexcept {
    const std::int32_t cells = std::min(at_once, size.width - x);
    const std::uint32_t without = bits_of_free(&labels[place(x, y)], cells);
    return without == 0 ? 0 : without & bits_of_read(&counts[place(x, y)], cells, least_readings);
  }
  /// Bit i: cell (x + i, y), not of the first row or the last, is a middle.
  std::uint32_t middles_from(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint32_t here = free_from(x, y);
    if (here == 0) return 0;
    const auto before = static_cast<std::uint32_t>(is_free(x - 1, y)),
               after = static_cast<std::uint32_t>(is_free(x + at_once, y));
    const std::uint32_t row = here & (here << 1U | before) & (here >> 1U | after << (at_once - 1));
    return row == 0 ? 0 : row & free_from(x, y - 1) & free_from(x, y + 1);
  }
  /// Marks with 0 the cells without a plane around a middle.
  void mark_around(std::int32_t x, std::int32_t y) const noexcept {
    for (std::int32_t j = std::max<std::int32_t>(y - reach, 0); j <= std::min(y + reach, size.height - 1);
         ++j) {
      for (std::int32_t i = std::max<std::int32_t>(x - reach, 0); i <= std::min(x + reach, size.width - 1);
           ++i) {
        if (labels[place(i, j)] == 0) marks.row(j)[i] = 0;
      }
    }
  }
};

}  // namespace

std::uint32_t free_cells(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                         ImageView<std::uint16_t> marks) noexcept {
  for (std::int32_t y = 0; y < marks.height; ++y) std::fill_n(marks.row(y), marks.width, taken);
  const int finest = cells.finest();
  const std::int32_t side = DepthCells::side_of(finest);
  const Grid grid{cell_labels, marks, cells.counts(), side * side / 2, cells.size(finest)};
  std::uint32_t middles = 0;
  for (std::int32_t y = 1; y + 1 < grid.size.height; ++y) {
    for (std::int32_t x = 0; x < grid.size.width; x += at_once) {
      for_bits(grid.middles_from(x, y), [&](std::uint32_t i) noexcept {
        ++middles;
        grid.mark_around(x + static_cast<std::int32_t>(i), y);
      });
    }
  }
  return middles;
}

ImageView<std::uint16_t> marks_in(ImageView<std::uint16_t> labels, const DepthCells& cells) noexcept {
  const Size size = cells.size(cells.finest());
  ImageView<std::uint16_t> marks = labels;
  marks.width = size.width;
  marks.height = size.height;
  marks.stride = labels.stride * DepthCells::side_of(cells.finest());
  return marks;
}

void spread_marks(std::int32_t side, ImageView<std::uint16_t> labels) noexcept {
  for (std::int32_t y = 0; y < labels.height; ++y) {
    std::uint16_t* row = labels.row(y);
    if (y % side != 0) {
      std::copy(labels.row(y - 1), labels.row(y - 1) + labels.width, row);
      continue;
    }
    // From the right, where no mark is overwritten that is still needed.
    std::int32_t x = (labels.width - 1) / side;
    for (; x >= 0 && (side != 4 || (x + 1) * side > labels.width); --x) {
      const std::uint16_t mark = row[x];
      std::fill(row + x * side, row + std::min((x + 1) * side, labels.width), mark);
    }
    // The usual side: four at once.
    for (; x >= 0; --x) std::fill_n(row + 4 * x, 4, std::uint16_t{row[x]});
  }
}

}  // namespace straightedge::detail
