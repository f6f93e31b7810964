// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/trigonometry.hpp"

namespace straightedge {

/// Direction cells of the array: the polar angle phi in `rows` equal steps, the azimuth theta in
/// 2 * rows equal steps in each of them. The textbook's accumulator, and easy to index; but all meridians
/// meet at the poles, so that the cells there are slivers: with 45 rows a cell at the equator has 28 times
/// the area of one at the pole. Votes of a plane whose normal lies near a pole are strewn over many cells,
/// and what is one peak elsewhere is a smear there.
struct HoughArrayRows {
  static constexpr std::int32_t cells_in_row(std::int32_t rows, std::int32_t) noexcept { return 2 * rows; }

  /// z = cos phi at the upper border of a row.
  static constexpr double top(std::int32_t rows, std::int32_t row, std::int32_t, std::int32_t) noexcept {
    return cosine(pi * row / rows);
  }
};

}  // namespace straightedge
