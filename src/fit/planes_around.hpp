// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/lowest_bit.hpp"
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
    Rows rows{};
    std::size_t word = 0;
    for (std::int32_t j = std::max<std::int32_t>(y - 1, 0); j <= bottom; ++j, word += words) {
      const std::uint16_t* from = labels.data() + static_cast<std::ptrdiff_t>(j) * size.width;
      if (end - begin == static_cast<std::int32_t>(cells) + 2) {
        rows[word] = four(from + begin) & no_marks;
        rows[word + 1] = four(from + begin + 4) & no_marks;
        rows[word + 2] = (from[begin + 8] | std::uint64_t{from[begin + 9]} << 16U) & no_marks;
        continue;
      }
      std::array<std::uint16_t, 4 * words> row{};
      std::copy(from + begin, from + end, row.begin() + (begin - x + 1));
      for (std::size_t i = 0; i < words; ++i) rows[word + i] = four(&row[4 * i]) & no_marks;
    }
    find(rows);
    for (std::size_t k = 0; k < count; ++k) {
      // Bit i + 1 stands for the column of cell i: what has the plane, and its neighbours.
      near[k] = (near[k] | near[k] >> 1U | near[k] >> 2U) & 0xFFU;
      several |= some & near[k];
      some |= near[k];
    }
  }

 private:
  static constexpr std::uint64_t no_marks = ~(LabelsAround::mark * four_ones);

  static constexpr std::size_t words = 3;  // of four labels each: a row
  using Rows = std::array<std::uint64_t, 3 * words>;

  /// Finds the planes, in the order of rows, each with its columns. Every plane is looked for in all words:
  /// how many have it nobody can foresee.
  void find(Rows& rows) noexcept {
    std::uint32_t left = 0;  // words with planes that are not found yet
    for (std::size_t i = 0; i < rows.size(); ++i) left |= static_cast<std::uint32_t>(rows[i] != 0) << i;
    while (left != 0) {
      const std::uint64_t first = rows[lowest_bit(left)];
      const auto same = static_cast<std::uint16_t>(first >> (lowest_bit(first) & 0x30U));
      std::array<std::uint64_t, words> equal{};
      left = 0;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::uint64_t here = ~not_zero(rows[i] ^ same * four_ones) >> 15U & four_ones;
        equal[i % words] |= here;
        rows[i] &= ~(here * 0xFFFFU);
        left |= static_cast<std::uint32_t>(rows[i] != 0) << i;
      }
      label[count] = same;
      near[count++] = lowest_of(equal[0]) | lowest_of(equal[1]) << 4U | lowest_of(equal[2]) << 8U;
    }
  }
};

}  // namespace straightedge::detail
