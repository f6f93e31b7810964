// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "four_labels.hpp"
#include "labels_around.hpp"
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The planes of eight cells beside one another and of those around them; bits say which cells have a plane
/// around.
struct PlanesAround {
  static constexpr std::size_t cells = 8, most = 3 * (cells + 2);
  std::array<std::uint16_t, most> label;
  std::array<std::uint32_t, most> near;
  std::size_t count = 0;
  std::uint32_t some = 0, several = 0;  ///< cells with a plane around, with more than one

  /// `labels` of all cells; LabelsAround::mark beside them is not looked at.
  PlanesAround(Size size, std::span<const std::uint16_t> labels, std::int32_t x, std::int32_t y) noexcept {
    const std::int32_t begin = std::max<std::int32_t>(x - 1, 0);
    const std::int32_t end = std::min(x + static_cast<std::int32_t>(cells) + 1, size.width);
    const std::int32_t bottom = std::min(y + 1, size.height - 1);
    const std::int32_t top = std::max<std::int32_t>(y - 1, 0), width = end - begin;
    const std::uint16_t* row = labels.data() + static_cast<std::ptrdiff_t>(top) * size.width + begin;
    const std::int32_t rows = are_the_same(row, {width, bottom - top + 1}, size.width) ? 1 : bottom - top + 1;
    for (std::int32_t j = 0; j < rows; ++j, row += size.width) add_row(row, width, begin - x + 1);
    for (std::size_t k = 0; k < count; ++k) {
      // Bit i + 1 stands for the column of cell i: what has the plane, and its neighbours.
      near[k] = (near[k] | near[k] >> 1U | near[k] >> 2U) & 0xFFU;
      several |= some & near[k];
      some |= near[k];
    }
  }

 private:
  static constexpr std::uint64_t no_marks = ~(LabelsAround::mark * four_ones);

  static std::uint16_t bare(std::uint16_t label) noexcept {
    return static_cast<std::uint16_t>(label & ~LabelsAround::mark);
  }
  /// Whether all labels of some rows are; not looked at where these are short.
  static bool are_the_same(const std::uint16_t* row, Size size, std::int32_t stride) noexcept {
    if (size.width < 4) return false;
    const std::uint64_t same = bare(*row) * four_ones;
    std::uint64_t differ = 0;
    for (std::int32_t y = 0; y < size.height; ++y, row += stride) {
      for (std::int32_t x = 0; x + 4 < size.width; x += 4) differ |= four(row + x) ^ same;
      differ |= four(row + size.width - 4) ^ same;
    }
    return (differ & no_marks) == 0;
  }
  void add_row(const std::uint16_t* labels, std::int32_t width, std::int32_t first) noexcept {
    for (std::int32_t x = 0; x < width;) {
      const std::int32_t begin = x;
      const std::uint16_t same = bare(labels[x]);
      while (x + 4 <= width && (four(labels + x) & no_marks) == same * four_ones) x += 4;
      while (x < width && bare(labels[x]) == same) ++x;
      if (same == 0) continue;
      std::size_t k = 0;
      while (k < count && label[k] != same) ++k;
      if (k == count) {
        label[count] = same;
        near[count++] = 0;
      }
      const auto bits = (1U << static_cast<std::uint32_t>(x - begin)) - 1U;
      near[k] |= bits << static_cast<std::uint32_t>(first + begin);
    }
  }
};

}  // namespace straightedge::detail
