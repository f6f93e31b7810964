// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The different planes of a cell and the eight around it, in the order of rows.
struct LabelsAround {
  /// Beside a label these say something about its cell; not looked at here.
  static constexpr std::uint16_t mark = 0xC000;

  static constexpr std::size_t most = 9;
  std::array<std::uint16_t, most> labels{};
  std::size_t count = 0;

  LabelsAround() noexcept = default;
  LabelsAround(Size size, std::span<const std::uint16_t> of_cells, std::int32_t x, std::int32_t y) noexcept {
    if (x > 0 && y > 0 && x + 1 < size.width && y + 1 < size.height) {
      const std::uint16_t* above = of_cells.data() + static_cast<std::ptrdiff_t>(y - 1) * size.width + x - 1;
      const std::uint16_t *here = above + size.width, *below = here + size.width;
      const auto label = static_cast<std::uint16_t>(above[0] & ~mark);
      std::uint32_t differ = 0;
      for (int i = 0; i < 3; ++i) differ |= (above[i] ^ label) | (here[i] ^ label) | (below[i] ^ label);
      if ((differ & ~std::uint32_t{mark}) == 0) {
        add(label);
        return;
      }
    }
    const std::int32_t left = std::max<std::int32_t>(x - 1, 0), right = std::min(x + 1, size.width - 1);
    for (std::int32_t j = std::max<std::int32_t>(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j) {
      const std::uint16_t* row = of_cells.data() + static_cast<std::ptrdiff_t>(j) * size.width;
      for (std::int32_t i = left; i <= right; ++i) add(static_cast<std::uint16_t>(row[i] & ~mark));
    }
  }

 private:
  void add(std::uint16_t label) noexcept {
    if (label == 0 || (count > 0 && labels[count - 1] == label)) return;
    for (std::size_t k = 0; k + 1 < count; ++k) {
      if (labels[k] == label) return;
    }
    labels[count++] = label;
  }
};

}  // namespace straightedge::detail
