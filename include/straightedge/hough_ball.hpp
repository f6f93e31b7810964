// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/trigonometry.hpp"

namespace straightedge {

/// Direction cells of the ball: rows about one cell high, and in each row as many cells as follow
/// sin(phi), so that all cells are nearly squares of one size and no direction is favoured.
///
///   1. Each pole is a round cell of its own. With h the height of a row, its radius is to be h / sqrt(pi),
///   the
///      area h²; so (rows − 2) h + 2 h / sqrt(pi) = pi.
///   2. A row whose middle has the polar angle phi gets pi sin(phi) / h cells, rounded, times two: an even
///      number, so that every cell has an antipode.
///   3. The borders between rows are moved a little, until every cell has exactly the same area: above a
///      border with c of N cells above it lies the share c / N of the sphere, so z = 1 − 2 c / N.
///
/// D. Borrmann, J. Elseberg, K. Lingemann, A. Nüchter, "The 3D Hough Transform for plane detection in point
/// clouds: A review and a new accumulator design", 3D Research 2:2, 2011, doi:10.1007/3DRes.02(2011)3.
/// Step 3 is of P. Leopardi, "A partition of the unit sphere into regions of equal area and small
/// diameter", Electronic Transactions on Numerical Analysis 25, 2006.
struct HoughBallRows {
  /// The height of a row in step 1.
  static constexpr double height(std::int32_t rows) noexcept {
    constexpr double two_per_root_pi = 1.1283791670955126;
    return pi / (rows - 2 + two_per_root_pi);
  }

  static constexpr std::int32_t cells_in_row(std::int32_t rows, std::int32_t row) noexcept {
    if (row == 0 || row == rows - 1) return 1;
    const double h = height(rows);
    // The upper half alone, so that rounding cannot make the halves differ.
    const std::int32_t from_pole = row < rows - 1 - row ? row : rows - 1 - row;
    const double phi = pi / 2 - (0.5 * (rows - 1) - from_pole) * h;
    const auto half = static_cast<std::int32_t>(pi * sine(phi) / h + 0.5);
    return half < 2 ? 4 : 2 * half;
  }

  /// z = cos phi at the upper border of a row with `above` of `all` cells above it.
  static constexpr double top(std::int32_t, std::int32_t, std::int32_t above, std::int32_t all) noexcept {
    return 1 - 2.0 * above / all;
  }
};

}  // namespace straightedge
