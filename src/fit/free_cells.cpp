// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "free_cells.hpp"

#include <algorithm>

namespace straightedge::detail {
namespace {

constexpr std::int32_t side = DepthCells::side;
constexpr double least_readings = side * side / 2.0;
constexpr std::uint16_t taken = 0xFFFF;
constexpr std::int32_t reach = 2;

struct Grid {
  const DepthCells& cells;
  std::span<const std::uint16_t> labels;
  std::span<std::uint16_t> marks;
  Size size;

  std::size_t place(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  }
  bool is_free(std::int32_t x, std::int32_t y) const noexcept {
    return labels[place(x, y)] == 0 && cells.level(0)[place(x, y)].n >= least_readings;
  }
  bool is_middle(std::int32_t x, std::int32_t y) const noexcept {
    return x > 0 && y > 0 && x + 1 < size.width && y + 1 < size.height && is_free(x, y) &&
           is_free(x - 1, y) && is_free(x + 1, y) && is_free(x, y - 1) && is_free(x, y + 1);
  }
  /// Marks with 0 the cells without a plane around a middle.
  void mark_around(std::int32_t x, std::int32_t y) const noexcept {
    for (std::int32_t j = std::max<std::int32_t>(y - reach, 0); j <= std::min(y + reach, size.height - 1); ++j) {
      for (std::int32_t i = std::max<std::int32_t>(x - reach, 0); i <= std::min(x + reach, size.width - 1); ++i) {
        if (labels[place(i, j)] == 0) marks[place(i, j)] = 0;
      }
    }
  }
};

}  // namespace

std::uint32_t free_cells(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                         std::span<std::uint16_t> marks, ImageView<std::uint16_t> labels) noexcept {
  std::fill(marks.begin(), marks.end(), taken);
  const Grid grid{cells, cell_labels, marks, cells.size(0)};
  std::uint32_t middles = 0;
  for (std::int32_t y = 0; y < grid.size.height; ++y) {
    for (std::int32_t x = 0; x < grid.size.width; ++x) {
      if (!grid.is_middle(x, y)) continue;
      ++middles;
      grid.mark_around(x, y);
    }
  }
  for (std::int32_t y = 0; y < labels.height; ++y) {
    std::uint16_t* row = labels.row(y);
    const std::uint16_t* mark = marks.data() + grid.place(0, y / side);
    for (std::int32_t x = 0; x < labels.width; ++x) row[x] = mark[x / side];
  }
  return middles;
}

}  // namespace straightedge::detail
