// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_cells.hpp"

#include <array>
#include <bit>

#include "straightedge/hough_plane_patches.hpp"

namespace straightedge::hough {
namespace {

constexpr std::int32_t side = hough_patch_side;

/// How many bits are set, and the sums of their numbers and of their squares. (std::popcount would call the
/// compiler's run-time library on machines without the instruction.)
struct RowSums {
  std::array<std::uint8_t, 256> count{};
  std::array<std::uint8_t, 256> v{};
  std::array<std::uint8_t, 256> vv{};
};

constexpr RowSums make_row_sums() noexcept {
  RowSums sums;
  for (std::uint32_t seen = 0; seen < 256; ++seen) {
    for (std::uint32_t v = 0; v < 8; ++v) {
      if ((seen >> v & 1U) == 0) continue;
      ++sums.count[seen];
      sums.v[seen] = static_cast<std::uint8_t>(sums.v[seen] + v);
      sums.vv[seen] = static_cast<std::uint8_t>(sums.vv[seen] + v * v);
    }
  }
  return sums;
}

constexpr RowSums row_sums = make_row_sums();
static_assert(row_sums.v[255] == 28 && row_sums.vv[255] == 140);

/// The pixels of one cell, rows `stride` floats apart.
struct CellPixels {
  const float* first = nullptr;
  std::ptrdiff_t stride = 0;
  std::int32_t rows = side;
};

/// Sums of each of a cell's columns; q counts from a reference, v from the cell's first row.
struct ColumnSums {
  std::array<float, side> q{}, qq{}, vq{};
  std::array<std::int32_t, side> seen{};  ///< bit v: there is a reading in that row
};

/// Whole cells without a mask are read where they are; others are copied, with 0 where no reading takes part.
CellPixels pixels_of(const DepthInput& input, std::int32_t x0, std::int32_t y0,
                     std::array<float, side * side>& copy) noexcept {
  const ImageView<const float>& picture = input.inverse_depth;
  const bool whole = x0 + side <= picture.width && y0 + side <= picture.height;
  const bool in_floats = picture.stride % static_cast<std::ptrdiff_t>(sizeof(float)) == 0;
  if (whole && in_floats && input.mask.data == nullptr) {
    return {picture.row(y0) + x0, picture.stride / static_cast<std::ptrdiff_t>(sizeof(float)), side};
  }
  copy = {};
  const std::int32_t columns = x0 + side < picture.width ? side : picture.width - x0;
  const std::int32_t rows = y0 + side < picture.height ? side : picture.height - y0;
  for (std::int32_t v = 0; v < rows; ++v) {
    const float* from = picture.row(y0 + v) + x0;
    float* to = copy.data() + v * side;
    const std::uint16_t* mask = input.mask.data == nullptr ? nullptr : input.mask.row(y0 + v) + x0;
    for (std::int32_t u = 0; u < columns; ++u) {
      const std::int32_t free = -static_cast<std::int32_t>(mask == nullptr || mask[u] == 0);
      to[u] = std::bit_cast<float>(std::bit_cast<std::int32_t>(from[u]) & free);
    }
  }
  return {copy.data(), side, side};
}

/// A reading of the cell, if it has any; one in its middle is asked first.
float reference_of(const CellPixels& cell) noexcept {
  const float middle = cell.first[side / 2 * cell.stride + side / 2];
  if (is_reading(middle)) return middle;
  for (std::ptrdiff_t v = 0; v < side; ++v) {
    for (std::ptrdiff_t u = 0; u < side; ++u) {
      if (is_reading(cell.first[v * cell.stride + u])) return cell.first[v * cell.stride + u];
    }
  }
  return 0;
}

/// No branch and no comparison of floats in the loop, so that a compiler takes several columns at a time:
/// the bits of floats above 0, read as integers, have the floats' order, and those of NaN and of negative
/// floats lie outside the range. Kept out of its caller, where compilers would take the sums apart into
/// single columns.
[[gnu::noinline]] ColumnSums sum_rows(const CellPixels& cell, float reference) noexcept {
  constexpr auto farthest = std::bit_cast<std::int32_t>(largest_reading);
  ColumnSums sums;
  for (std::int32_t v = 0; v < cell.rows; ++v) {
    const float* row = cell.first + v * cell.stride;
    const auto factor = static_cast<float>(v);
    const std::int32_t bit = 1 << v;
    for (std::size_t u = 0; u < side; ++u) {
      const auto bits = std::bit_cast<std::int32_t>(row[u]);
      const std::int32_t reading = -static_cast<std::int32_t>((bits > 0) & (bits <= farthest));
      const float difference = row[u] - reference;
      const auto q = std::bit_cast<float>(std::bit_cast<std::int32_t>(difference) & reading);
      sums.q[u] += q;
      sums.qq[u] += q * q;
      sums.vq[u] += factor * q;
      sums.seen[u] |= reading & bit;
    }
  }
  return sums;
}

/// The eight columns together, u from the first.
InverseDepthMoments sum_columns(const ColumnSums& columns) noexcept {
  std::int32_t n = 0, u_sum = 0, v_sum = 0, uu = 0, uv = 0, vv = 0;
  InverseDepthMoments m;
  for (std::int32_t u = 0; u < side; ++u) {
    const auto column = static_cast<std::size_t>(u);
    const auto seen = static_cast<std::size_t>(columns.seen[column]);
    const std::int32_t count = row_sums.count[seen];
    n += count;
    u_sum += u * count;
    uu += u * u * count;
    v_sum += row_sums.v[seen];
    uv += u * row_sums.v[seen];
    vv += row_sums.vv[seen];
    const auto q = static_cast<double>(columns.q[column]);
    m.q += q;
    m.uq += u * q;
    m.vq += static_cast<double>(columns.vq[column]);
    m.qq += static_cast<double>(columns.qq[column]);
  }
  m.n = n;
  m.u = u_sum;
  m.v = v_sum;
  m.uu = uu;
  m.uv = uv;
  m.vv = vv;
  return m;
}

/// The same sums with q counted from 0 again.
InverseDepthMoments with_reference(InverseDepthMoments m, double reference) noexcept {
  m.qq += 2 * reference * m.q + reference * reference * m.n;
  m.q += reference * m.n;
  m.uq += reference * m.u;
  m.vq += reference * m.v;
  return m;
}

}  // namespace

void sum_cells(const DepthInput& input, std::span<InverseDepthMoments> cells) noexcept {
  std::array<float, side * side> copy;
  std::size_t cell = 0;
  for (std::int32_t y0 = 0; y0 < input.inverse_depth.height; y0 += side) {
    for (std::int32_t x0 = 0; x0 < input.inverse_depth.width; x0 += side, ++cell) {
      const CellPixels pixels = pixels_of(input, x0, y0, copy);
      const float reference = reference_of(pixels);
      const InverseDepthMoments local = sum_columns(sum_rows(pixels, reference));
      cells[cell] = with_reference(local, static_cast<double>(reference)).seen_from(-x0, -y0);
    }
  }
}

void sum_four(std::span<const InverseDepthMoments> fine, Size fine_cells,
              std::span<InverseDepthMoments> coarse) noexcept {
  const std::int32_t columns = (fine_cells.width + 1) / 2;
  for (InverseDepthMoments& m : coarse) m = {};
  std::size_t at = 0;
  for (std::int32_t y = 0; y < fine_cells.height; ++y) {
    for (std::int32_t x = 0; x < fine_cells.width; ++x, ++at) {
      coarse[static_cast<std::size_t>(y / 2 * columns + x / 2)].add(fine[at]);
    }
  }
}

}  // namespace straightedge::hough
