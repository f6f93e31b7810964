// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "free_cells.hpp"

#include <algorithm>

namespace straightedge::detail {
namespace {

constexpr std::uint16_t taken = 0xFFFF;
constexpr std::int32_t reach = 2;

struct Grid {
  std::span<const std::uint16_t> labels;
  ImageView<std::uint16_t> marks;
  std::span<const std::uint8_t> counts;
  std::int32_t least_readings;
  Size size;

  std::size_t place(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  }
  /// Four cells beside one another; nearly everywhere they are.
  bool all_taken(std::size_t i) const noexcept {
    return labels[i] != 0 && labels[i + 1] != 0 && labels[i + 2] != 0 && labels[i + 3] != 0;
  }
  bool is_free(std::int32_t x, std::int32_t y) const noexcept {
    return labels[place(x, y)] == 0 && counts[place(x, y)] >= least_readings;
  }
  bool is_middle(std::int32_t x, std::int32_t y) const noexcept {
    return x > 0 && y > 0 && x + 1 < size.width && y + 1 < size.height && is_free(x, y) &&
           is_free(x - 1, y) && is_free(x + 1, y) && is_free(x, y - 1) && is_free(x, y + 1);
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
  for (std::int32_t y = 0; y < grid.size.height; ++y) {
    for (std::int32_t x = 0; x < grid.size.width; ++x) {
      while (x + 4 <= grid.size.width && grid.all_taken(grid.place(x, y))) x += 4;
      if (x == grid.size.width || !grid.is_middle(x, y)) continue;
      ++middles;
      grid.mark_around(x, y);
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
    for (std::int32_t x = (labels.width - 1) / side; x >= 0; --x) {
      const std::uint16_t mark = row[x];
      std::fill(row + x * side, row + std::min((x + 1) * side, labels.width), mark);
    }
  }
}

}  // namespace straightedge::detail
