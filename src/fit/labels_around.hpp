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
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The different planes of a cell and the eight around it, in the order of rows.
struct LabelsAround {
  /// Beside a label these say something about its cell; not looked at here.
  static constexpr std::uint16_t mark = 0xC000;

  static constexpr std::size_t most = 9;
  std::array<std::uint16_t, most> labels;
  std::size_t count = 0;

  LabelsAround() noexcept = default;
  LabelsAround(Size size, std::span<const std::uint16_t> of_cells, std::int32_t x, std::int32_t y) noexcept {
    const std::int32_t left = std::max<std::int32_t>(x - 1, 0), right = std::min(x + 1, size.width - 1);
    std::array<std::uint64_t, 3> rows{};
    for (std::int32_t j = std::max<std::int32_t>(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j) {
      const std::uint16_t* row = of_cells.data() + static_cast<std::ptrdiff_t>(j) * size.width;
      // At a border the cell itself stands for what is not there.
      const std::uint64_t three = row[left] | std::uint64_t{row[x]} << 16U | std::uint64_t{row[right]} << 32U;
      rows[static_cast<std::size_t>(j - y + 1)] = three & ~(mark * four_ones);
    }
    find(rows);
  }

 private:
  /// Each label that is left, and no more of it.
  void find(std::array<std::uint64_t, 3>& rows) noexcept {
    while ((rows[0] | rows[1] | rows[2]) != 0) {
      const std::uint64_t below = rows[1] != 0 ? rows[1] : rows[2], first = rows[0] != 0 ? rows[0] : below;
      const auto same = static_cast<std::uint16_t>(first >> (lowest_bit(first) & 0x30U));
      for (std::uint64_t& row : rows) {
        const std::uint64_t equal = ~not_zero(row ^ same * four_ones) >> 15U & four_ones;
        row &= ~(equal * 0xFFFFU);
      }
      labels[count++] = same;
    }
  }
};

}  // namespace straightedge::detail
