// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace straightedge {
namespace {

constexpr std::int32_t most_counted = 255;

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

/// A whole cell whose pixels all have a reading: what does not depend on q is known.
struct FullCells {
  double n, first, second, mixed;  // sums of 1, u, uu, uv from the cell's corner

  explicit FullCells(double side) noexcept
      : n(side * side),
        first(side * (side * (side - 1) / 2)),
        second(first * (2 * side - 1) / 3),
        mixed(side * (side - 1) / 2 * (side * (side - 1) / 2)) {}
  InverseDepthMoments at(double left, double top, const DepthCellSums& sums) const noexcept {
    const double u = first + n * left, v = first + n * top;
    return {n,
            u,
            v,
            second + left * (first + u),
            mixed + left * first + top * u,
            second + top * (first + v),
            sums.q,
            sums.uq + left * sums.q,
            sums.vq + top * sums.q,
            sums.qq};
  }
};

/// A whole cell some of whose pixels have no reading: q is summed up already.
InverseDepthMoments of_broken_cell(ImageView<const float> inverse_depth, std::int32_t side, std::int32_t left,
                                   std::int32_t top, const DepthCellSums& sums) noexcept {
  std::int32_t n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  for (std::int32_t y = 0; y < side; ++y) {
    const float* row = inverse_depth.row(top + y) + left;
    std::int32_t of_row = 0, u_of_row = 0, uu_of_row = 0;
    for (std::int32_t x = 0; x < side; ++x) {
      const std::int32_t reads = static_cast<std::int32_t>(row[x] > 0);
      of_row += reads;
      u_of_row += x * reads;
      uu_of_row += x * x * reads;
    }
    n += of_row;
    u += u_of_row;
    uu += uu_of_row;
    v += y * of_row;
    uv += y * u_of_row;
    vv += y * y * of_row;
  }
  const auto number = [](std::int32_t i) noexcept { return static_cast<double>(i); };
  const InverseDepthMoments cell{number(n),  number(u), number(v), number(uu), number(uv),
                                 number(vv), sums.q,    sums.uq,   sums.vq,    sums.qq};
  return cell.seen_from(-left, -top);
}

/// Cells of one size in a picture.
struct CellRow {
  ImageView<const float> inverse_depth;
  std::int32_t side, top;

  InverseDepthMoments sum(std::int32_t left) const noexcept {
    const std::int32_t right = std::min(left + side, inverse_depth.width);
    return sum_cell(inverse_depth, left, top, right, std::min(top + side, inverse_depth.height))
        .seen_from(-left, -top);
  }
  /// Whole cells.
  void add(std::int32_t first, std::span<const DepthCellSums> sums, InverseDepthMoments* out,
           std::uint8_t* counts) const noexcept {
    const std::int32_t full = side * side;
    const FullCells cells(side);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const std::int32_t left = (first + static_cast<std::int32_t>(i)) * side;
      counts[i] = static_cast<std::uint8_t>(std::min(sums[i].n, most_counted));
      if (sums[i].n == full) {
        out[i] = cells.at(left, top, sums[i]);
      } else {
        out[i] =
            sums[i].n == 0 ? InverseDepthMoments{} : of_broken_cell(inverse_depth, side, left, top, sums[i]);
      }
    }
  }
};

}  // namespace

void DepthCells::build(ImageView<const float> inverse_depth, const DepthKernels& kernels) noexcept {
  // Step 1.
  constexpr std::int32_t at_once = 16;
  std::array<DepthCellSums, at_once> sums;
  const Size cells = size(finest_);
  const std::int32_t pixels = side_of(finest_), whole_columns = inverse_depth.width / pixels;
  InverseDepthMoments* out = level(finest_).data();
  std::uint8_t* counts = counts_.data();
  for (std::int32_t y = 0; y < cells.height; ++y, out += cells.width, counts += cells.width) {
    const CellRow row{inverse_depth, pixels, y * pixels};
    std::int32_t x = 0;
    if (row.top + pixels <= inverse_depth.height) {
      for (; x < whole_columns; x += at_once) {
        const std::int32_t count = std::min(at_once, whole_columns - x);
        const float* corner = inverse_depth.row(row.top) + static_cast<std::ptrdiff_t>(x) * pixels;
        kernels.sum_cells({corner, inverse_depth.stride / static_cast<std::ptrdiff_t>(sizeof(float))}, pixels,
                          count, sums.data());
        row.add(x, std::span(sums).first(static_cast<std::size_t>(count)), out + x, counts + x);
      }
      x = whole_columns;
    }
    for (; x < cells.width; ++x) {
      out[x] = row.sum(x * pixels);
      counts[x] = static_cast<std::uint8_t>(std::min(static_cast<std::int32_t>(out[x].n), most_counted));
    }
  }
  sum_up();
}

void DepthCells::sum_up() noexcept {
  // Step 2.
  for (int fine = finest_; fine + 1 < levels; ++fine) {
    const Size from = size(fine), to = size(fine + 1);
    InverseDepthMoments* out = level(fine + 1).data();
    for (std::int32_t y = 0; y < to.height; ++y) {
      const InverseDepthMoments* upper = level(fine).data() + static_cast<std::ptrdiff_t>(2 * y) * from.width;
      const InverseDepthMoments* lower = 2 * y + 1 < from.height ? upper + from.width : nullptr;
      for (std::int32_t x = 0; x < to.width; ++x, ++out) {
        const bool pair = 2 * x + 1 < from.width;
        *out = upper[2 * x];
        if (pair) out->add(upper[2 * x + 1]);
        if (lower != nullptr) out->add(lower[2 * x]);
        if (lower != nullptr && pair) out->add(lower[2 * x + 1]);
      }
    }
  }
}

}  // namespace straightedge
