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
  return cell;
}

/// Cells of one size in a row of the picture.
struct CellRow {
  ImageView<const float> inverse_depth;
  std::int32_t side, top;
  DepthCells& cells;

  void sum(std::int32_t x, std::size_t place) const noexcept {
    const std::int32_t left = x * side, right = std::min(left + side, inverse_depth.width);
    set(sum_cell(inverse_depth, left, top, right, std::min(top + side, inverse_depth.height)), x, place);
  }
  /// Whole cells, the first of them x.
  void add(std::int32_t x, std::span<const DepthCellSums> sums, std::size_t place,
           const DepthKernels& kernels) const noexcept {
    const std::int32_t full = side * side, count = static_cast<std::int32_t>(sums.size());
    kernels.whole_cells(sums.data(), side, count, static_cast<float>(x * side - cells.middle_u()),
                        static_cast<float>(top - cells.middle_v()), cells.rows(cells.finest(), place));
    for (std::size_t i = 0; i < sums.size(); ++i) {
      cells.counts()[place + i] = static_cast<std::uint8_t>(std::min(sums[i].n, most_counted));
      if (sums[i].n == full) continue;
      const std::int32_t column = x + static_cast<std::int32_t>(i);
      set(sums[i].n == 0 ? InverseDepthMoments{}
                         : of_broken_cell(inverse_depth, side, column * side, top, sums[i]),
          column, place + i);
    }
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

/// Up to two rows of up to two cells that make one at the picture's border.
struct CornerCells {
  std::array<float, std::size_t{4} * DepthCellRows::kinds> of{};

  CornerCells(const DepthCellRows& from, std::int32_t width, std::int32_t across,
              std::int32_t down) noexcept {
    for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) {
      for (std::int32_t y = 0; y < down; ++y) {
        for (std::int32_t x = 0; x < across; ++x) {
          of[static_cast<std::size_t>(4 * kind + 2 * y + x)] = from.first[kind * from.apart + y * width + x];
        }
      }
    }
  }
  DepthCellRows rows() noexcept { return {of.data(), 4}; }
};

std::size_t place_of(Size size, std::int32_t x, std::int32_t y) noexcept {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

}  // namespace

void DepthCells::set(int level, std::size_t place, const DepthCell& cell) noexcept {
  const DepthCellRows r = rows(level, place);
  const float numbers[DepthCellRows::kinds] = {cell.n,  cell.u,  cell.v,  cell.q,  cell.uu,
                                               cell.uv, cell.vv, cell.uq, cell.vq, cell.qq};
  for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) r.first[kind * r.apart] = numbers[kind];
}

InverseDepthMoments DepthCells::moments(int level, std::size_t place) const noexcept {
  const DepthCell cell = at(level, place);
  const auto number = [](float x) noexcept { return static_cast<double>(x); };
  const double n = number(cell.n), q = number(cell.q);
  const double u = number(cell.u) + middle_u_, v = number(cell.v) + middle_v_;
  if (!(n > 0)) return {};
  return {n,
          n * u,
          n * v,
          n * u * u + number(cell.uu),
          n * u * v + number(cell.uv),
          n * v * v + number(cell.vv),
          n * q,
          n * u * q + number(cell.uq),
          n * v * q + number(cell.vq),
          n * q * q + number(cell.qq)};
}

void DepthCells::build_row(ImageView<const float> inverse_depth, std::int32_t y,
                           const DepthKernels& kernels) noexcept {
  // Step 1.
  constexpr std::int32_t at_once = 16;
  std::array<DepthCellSums, at_once> sums;
  const Size cells = size(finest_);
  const std::int32_t pixels = side_of(finest_), whole_columns = inverse_depth.width / pixels;
  const CellRow row{inverse_depth, pixels, y * pixels, *this};
  std::int32_t x = 0;
  if (row.top + pixels <= inverse_depth.height) {
    for (; x < whole_columns; x += at_once) {
      const std::int32_t count = std::min(at_once, whole_columns - x);
      const float* corner = inverse_depth.row(row.top) + static_cast<std::ptrdiff_t>(x) * pixels;
      kernels.sum_cells({corner, inverse_depth.stride / static_cast<std::ptrdiff_t>(sizeof(float))}, pixels,
                        count, sums.data());
      row.add(x, std::span(sums).first(static_cast<std::size_t>(count)), place_of(cells, x, y), kernels);
    }
    x = whole_columns;
  }
  for (; x < cells.width; ++x) row.sum(x, place_of(cells, x, y));
}

void DepthCells::build(ImageView<const float> inverse_depth, const DepthKernels& kernels) noexcept {
  for (std::int32_t y = 0; y < size(finest_).height; ++y) build_row(inverse_depth, y, kernels);
  sum_up(kernels);
}

void DepthCells::sum_up(const DepthKernels& kernels) noexcept {
  // Step 2.
  for (int fine = finest_; fine + 1 < levels; ++fine) {
    const Size from = size(fine), to = size(fine + 1);
    for (std::int32_t y = 0; y < to.height; ++y) {
      const std::int32_t down = std::min<std::int32_t>(2, from.height - 2 * y),
                         whole = down == 2 ? from.width / 2 : 0;
      kernels.join_cells(rows(fine, place_of(from, 0, 2 * y)), from.width, whole,
                         rows(fine + 1, place_of(to, 0, y)));
      for (std::int32_t x = whole; x < to.width; ++x) {
        CornerCells corner(rows(fine, place_of(from, 2 * x, 2 * y)), from.width,
                           std::min<std::int32_t>(2, from.width - 2 * x), down);
        kernels.join_cells(corner.rows(), 2, 1, rows(fine + 1, place_of(to, x, y)));
      }
    }
  }
}

}  // namespace straightedge
