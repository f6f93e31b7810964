// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_cells.hpp"

#include <algorithm>
#include <cstddef>

namespace straightedge {
namespace {

constexpr std::int32_t most_counted = 255;

/// Sums of one cell; u and v count from its corner.
InverseDepthMoments sum_cell(ImageView<const float> inverse_depth, std::int32_t left,
                             std::int32_t right) noexcept {
  InverseDepthMoments m;
  for (std::int32_t y = 0; y < inverse_depth.height; ++y) {
    const float* row = inverse_depth.row(y);
    for (std::int32_t x = left; x < right; ++x) {
      if (row[x] > 0) m.add(x - left, y, static_cast<double>(row[x]));
    }
  }
  return m;
}

/// Cells of one size in a row of the picture, and its pixels.
struct CellRow {
  ImageView<const float> inverse_depth;
  std::int32_t side, top;
  DepthCells& cells;

  void sum(std::int32_t x, std::size_t place) const noexcept {
    const std::int32_t left = x * side, right = std::min(left + side, inverse_depth.width);
    set(sum_cell(inverse_depth, left, right), x, place);
  }

 private:
  /// Sums counted from the cell's corner.
  void set(const InverseDepthMoments& m, std::int32_t x, std::size_t place) const noexcept {
    const double n = m.n > 0 ? m.n : 1;
    const double u = m.u / n, v = m.v / n, q = m.q / n;
    const auto number = [](double sum) noexcept { return static_cast<float>(sum); };
    cells.set(cells.finest(), place,
              {number(m.n), number(u + (x * side - cells.middle_u())), number(v + (top - cells.middle_v())),
               number(q), number(m.uu - u * m.u), number(m.uv - u * m.v), number(m.vv - v * m.v),
               number(m.uq - u * m.q), number(m.vq - v * m.q), number(m.qq - q * m.q)});
    cells.counts()[place] = static_cast<std::uint8_t>(std::min(static_cast<std::int32_t>(m.n), most_counted));
  }
};

}  // namespace

void DepthCells::set(int level, std::size_t place, const DepthCell& cell) noexcept {
  const DepthCellRows r = rows(level, place);
  const float numbers[DepthCellRows::kinds] = {cell.n,  cell.u,  cell.v,  cell.q,  cell.uu,
                                               cell.uv, cell.vv, cell.uq, cell.vq, cell.qq};
  for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) r.first[kind * r.apart] = numbers[kind];
}

void DepthCells::build_row(ImageView<const float> inverse_depth, std::int32_t y,
                           const DepthKernels& kernels) noexcept {
  // Step 1.
  const Size cells = size(finest_);
  const std::int32_t pixels = side_of(finest_), whole_columns = inverse_depth.width / pixels;
  const CellRow row{inverse_depth, pixels, y * pixels, *this};
  std::int32_t x = 0;
  if (inverse_depth.height >= pixels) {
    const std::size_t place = place_of(cells, 0, y);
    kernels.build_cells(
        {inverse_depth.row(0), inverse_depth.stride / static_cast<std::ptrdiff_t>(sizeof(float))}, pixels,
        whole_columns, -middle_u_, row.top - middle_v_, rows(finest_, place), counts().subspan(place).data());
    x = whole_columns;
  }
  for (; x < cells.width; ++x) row.sum(x, place_of(cells, x, y));
  join_up(y, kernels);
}

void DepthCells::build(ImageView<const float> inverse_depth, const DepthKernels& kernels) noexcept {
  const std::int32_t pixels = side_of(finest_);
  for (std::int32_t y = 0; y < size(finest_).height; ++y) {
    ImageView<const float> band = inverse_depth;
    band.data = inverse_depth.row(y * pixels);
    band.height = std::min(pixels, inverse_depth.height - y * pixels);
    build_row(band, y, kernels);
  }
}

}  // namespace straightedge
