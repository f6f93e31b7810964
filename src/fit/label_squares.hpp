// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "four_labels.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// A square of smallest cells that have one label: a cell of its level. Or two smallest cells side by side.
struct LabelSquare {
  std::uint32_t place;  ///< of the cell in its level; of the left one of two
  std::uint16_t label;
  std::uint8_t level;
  std::uint8_t second;  ///< 1: and the cell to the right of it
};

/// The smallest cells in squares of one label, as large as they come: 4x4 cells, 2x2, single ones. There are
/// far fewer of these than cells.
///
/// Along the borders of planes nobody can foresee which they are: all squares that may be are written to a
/// list, and those that are not one are written over by the next.
class LabelSquares {
 public:
  /// Labels without any of the `wanted` bits are left out.
  LabelSquares(const DepthCells& cells, ImageView<const std::uint16_t> labels, std::uint16_t wanted,
               bool in_pairs) noexcept
      : cells_(cells), labels_(labels), wanted_(wanted), in_pairs_(in_pairs) {}

  /// Calls visit(square) for each.
  template <class Visit>
  void for_each(const Visit& visit) noexcept {
    for (std::int32_t y = 0; y < labels_.height; y += side) {
      for (std::int32_t x = 0; x < labels_.width; x += side) {
        find(x, y);
        if (count_ > room - cells_of_one) empty(visit);
      }
    }
    empty(visit);
  }

 private:
  static constexpr std::int32_t side = 4;
  static constexpr std::size_t cells_of_one = 16, room = 7 * cells_of_one;

  /// Four rows of four labels from a cell on. Beyond the border the last one in the picture stands again.
  struct Sixteen {
    std::int32_t columns, rows;  ///< in the picture
    std::array<std::uint64_t, 4> row;
  };

  Sixteen sixteen(std::int32_t x, std::int32_t y) const noexcept {
    Sixteen labels{std::min(labels_.width - x, side), std::min(labels_.height - y, side), {}};
    for (std::int32_t j = 0; j < side; ++j) {
      const std::uint16_t* from = labels_.row(y + std::min(j, labels.rows - 1)) + x;
      std::uint64_t& row = labels.row[static_cast<std::size_t>(j)];
      if (labels.columns == side) {
        row = four(from);
        continue;
      }
      for (std::int32_t i = 0; i < side; ++i)
        row |= std::uint64_t{from[std::min(i, labels.columns - 1)]} << (16 * i);
    }
    return labels;
  }

  void find(std::int32_t x, std::int32_t y) noexcept {
    const Sixteen labels = sixteen(x, y);
    const std::uint64_t first = (labels.row[0] & 0xFFFF) * four_ones;
    std::uint64_t differ = 0, some = 0;
    for (const std::uint64_t row : labels.row) {
      differ |= row ^ first;
      some |= row;
    }
    if ((some & wanted_ * four_ones) == 0) return;
    const int level = cells_.finest() + 2;
    if (differ == 0 && level < DepthCells::levels) {
      offer(level, x / 4, y / 4, static_cast<std::uint16_t>(labels.row[0]), true);
      return;
    }
    for (std::int32_t j = 0; j < labels.rows; j += 2) {
      for (std::int32_t i = 0; i < labels.columns; i += 2) find_in_four(labels, i, j, x + i, y + j);
    }
  }

  /// The square of 2x2 labels (i, j) of the sixteen, whose first cell is (x, y).
  void find_in_four(const Sixteen& labels, std::int32_t i, std::int32_t j, std::int32_t x,
                    std::int32_t y) noexcept {
    const std::uint64_t top = labels.row[static_cast<std::size_t>(j)] >> (16 * i),
                        bottom = labels.row[static_cast<std::size_t>(j) + 1] >> (16 * i);
    const auto a = static_cast<std::uint16_t>(top), b = static_cast<std::uint16_t>(top >> 16U),
               c = static_cast<std::uint16_t>(bottom), d = static_cast<std::uint16_t>(bottom >> 16U);
    const bool is_one = ((a ^ b) | (a ^ c) | (a ^ d)) == 0, is_wide = i + 1 < labels.columns;
    offer(cells_.finest() + 1, x / 2, y / 2, a, is_one);
    find_in_row(x, y, a, b, !is_one, is_wide);
    find_in_row(x, y + 1, c, d, !is_one & (j + 1 < labels.rows), is_wide);
  }
  void find_in_row(std::int32_t x, std::int32_t y, std::uint16_t left, std::uint16_t right, bool are_any,
                   bool are_two) noexcept {
    const int level = cells_.finest();
    const bool together = are_two & (left == right) & in_pairs_;
    offer(level, x, y, left, are_any, together ? 1 : 0);
    offer(level, x + 1, y, right, are_any & are_two & !together);
  }

  void offer(int level, std::int32_t x, std::int32_t y, std::uint16_t label, bool is_one,
             std::uint8_t second = 0) noexcept {
    found_[count_] = {static_cast<std::uint32_t>(y * cells_.size(level).width + x), label,
                      static_cast<std::uint8_t>(level), second};
    count_ += static_cast<std::size_t>(is_one & ((label & wanted_) != 0));
  }

  template <class Visit>
  void empty(const Visit& visit) noexcept {
    for (std::size_t k = 0; k < count_; ++k) visit(found_[k]);
    count_ = 0;
  }

  const DepthCells& cells_;
  ImageView<const std::uint16_t> labels_;
  std::uint16_t wanted_;
  bool in_pairs_;
  std::size_t count_ = 0;
  std::array<LabelSquare, room + 1> found_;  // the last one is only ever written over
};

}  // namespace straightedge::detail
