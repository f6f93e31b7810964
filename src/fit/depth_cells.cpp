// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_cells.hpp"

#include <algorithm>

namespace straightedge {
namespace {

/// Sums of one cell; u and v count from its corner.
InverseDepthMoments sum_cell(ImageView<const float> inverse_depth, std::int32_t left, std::int32_t top,
                             std::int32_t right, std::int32_t bottom) noexcept {
  InverseDepthMoments m;
  for (std::int32_t y = top; y < bottom; ++y) {
    const float* row = inverse_depth.row(y);
    for (std::int32_t x = left; x < right; ++x) {
      if (row[x] > 0) m.add(x - left, y - top, static_cast<double>(row[x]));
    }
  }
  return m;
}

/// The sums of a whole cell whose pixels all have a reading: what does not depend on q is known.
bool sum_full_cell(ImageView<const float> inverse_depth, std::int32_t left, std::int32_t top,
                   InverseDepthMoments& m) noexcept {
  constexpr double n = 16, first = 24, second = 56, mixed = 36;
  double q = 0, uq = 0, vq = 0, qq = 0;
  bool full = true;
  for (std::int32_t y = 0; y < DepthCells::side; ++y) {
    const float* row = inverse_depth.row(top + y) + left;
    const double q0 = static_cast<double>(row[0]), q1 = static_cast<double>(row[1]);
    const double q2 = static_cast<double>(row[2]), q3 = static_cast<double>(row[3]);
    full = full && q0 > 0 && q1 > 0 && q2 > 0 && q3 > 0;
    const double sum = (q0 + q1) + (q2 + q3);
    q += sum;
    vq += y * sum;
    uq += (q1 + 2 * q2) + 3 * q3;
    qq += (q0 * q0 + q1 * q1) + (q2 * q2 + q3 * q3);
  }
  m = {n, first, first, second, mixed, second, q, uq, vq, qq};
  return full;
}

}  // namespace

void DepthCells::build(ImageView<const float> inverse_depth) noexcept {
  // Step 1.
  const Size cells = size(0);
  InverseDepthMoments* out = level(0).data();
  for (std::int32_t cy = 0; cy < cells.height; ++cy) {
    const std::int32_t top = cy * side, bottom = std::min(top + side, inverse_depth.height);
    for (std::int32_t cx = 0; cx < cells.width; ++cx, ++out) {
      const std::int32_t left = cx * side, right = std::min(left + side, inverse_depth.width);
      const bool whole = right - left == side && bottom - top == side;
      if (!whole || !sum_full_cell(inverse_depth, left, top, *out)) {
        *out = sum_cell(inverse_depth, left, top, right, bottom);
      }
      *out = out->seen_from(-left, -top);
    }
  }
  sum_up();
}

void DepthCells::sum_up() noexcept {
  // Step 2.
  for (int fine = 0; fine + 1 < levels; ++fine) {
    const Size from = size(fine), to = size(fine + 1);
    const InverseDepthMoments* cells = level(fine).data();
    InverseDepthMoments* out = level(fine + 1).data();
    for (std::int32_t y = 0; y < to.height; ++y) {
      for (std::int32_t x = 0; x < to.width; ++x, ++out) {
        *out = {};
        for (std::int32_t j = 2 * y; j < std::min(2 * y + 2, from.height); ++j) {
          for (std::int32_t i = 2 * x; i < std::min(2 * x + 2, from.width); ++i) {
            out->add(cells[static_cast<std::ptrdiff_t>(j) * from.width + i]);
          }
        }
      }
    }
  }
}

}  // namespace straightedge
