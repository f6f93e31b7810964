// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_cells.hpp"

#include <array>

#include "straightedge/hough_plane_patches.hpp"

namespace straightedge::hough {
namespace {

constexpr std::int32_t side = hough_patch_side;
constexpr float nearest = 1e4F;  // 1/metre; a reading beyond is no reading

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

bool is_reading(float q) noexcept {
  return q > 0 && q <= nearest;
}

/// A reading of this cell, if it has any; its middle one is asked first.
float reference_of(const DepthInput& input, std::int32_t x0, std::int32_t y0) noexcept {
  const ImageView<const float>& picture = input.inverse_depth;
  const std::int32_t x1 = x0 + side < picture.width ? x0 + side : picture.width;
  const std::int32_t y1 = y0 + side < picture.height ? y0 + side : picture.height;
  const float middle = picture.at((x0 + x1) / 2, (y0 + y1) / 2);
  if (is_reading(middle)) return middle;
  for (std::int32_t y = y0; y < y1; ++y) {
    for (std::int32_t x = x0; x < x1; ++x) {
      if (is_reading(picture.at(x, y))) return picture.at(x, y);
    }
  }
  return 0;
}

void start_columns(const DepthInput& input, std::int32_t y0, const ColumnSums& columns) noexcept {
  const std::int32_t width = input.inverse_depth.width;
  for (std::int32_t x0 = 0; x0 < width; x0 += side) {
    const float reference = reference_of(input, x0, y0);
    for (std::int32_t u = 0; u < side; ++u) columns.reference[static_cast<std::size_t>(x0 + u)] = reference;
  }
  for (std::size_t x = 0; x < columns.seen.size(); ++x) {
    columns.q[x] = columns.qq[x] = columns.vq[x] = 0;
    columns.seen[x] = 0;
  }
}

/// No branch in the loop, so that a compiler may take several pixels at a time.
template <class IsFree>
void add_row(const float* row, std::int32_t width, std::int32_t v, const ColumnSums& columns,
             IsFree is_free) noexcept {
  const float* const reference = columns.reference.data();
  float* const q_sum = columns.q.data();
  float* const qq_sum = columns.qq.data();
  float* const vq_sum = columns.vq.data();
  std::uint32_t* const seen = columns.seen.data();
  const auto factor = static_cast<float>(v);
  const std::uint32_t bit = 1U << static_cast<std::uint32_t>(v);
  for (std::int32_t x = 0; x < width; ++x) {
    const bool reading = (row[x] > 0) & (row[x] <= nearest) & is_free(x);
    const float q = reading ? row[x] - reference[x] : 0.0F;
    q_sum[x] += q;
    qq_sum[x] += q * q;
    vq_sum[x] += factor * q;
    seen[x] |= reading ? bit : 0U;
  }
}

/// The eight columns of a cell together, u from its first column, q from its reference.
InverseDepthMoments sum_columns(const ColumnSums& columns, std::int32_t x0) noexcept {
  std::int32_t n = 0, u_sum = 0, v_sum = 0, uu = 0, uv = 0, vv = 0;
  InverseDepthMoments m;
  for (std::int32_t u = 0; u < side; ++u) {
    const auto x = static_cast<std::size_t>(x0 + u);
    const std::uint32_t seen = columns.seen[x];
    const std::int32_t count = row_sums.count[seen];
    n += count;
    u_sum += u * count;
    uu += u * u * count;
    v_sum += row_sums.v[seen];
    uv += u * row_sums.v[seen];
    vv += row_sums.vv[seen];
    const auto q = static_cast<double>(columns.q[x]);
    m.q += q;
    m.uq += u * q;
    m.vq += static_cast<double>(columns.vq[x]);
    m.qq += static_cast<double>(columns.qq[x]);
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

void sum_cells(const DepthInput& input, const ColumnSums& columns,
               std::span<InverseDepthMoments> cells) noexcept {
  const ImageView<const float>& picture = input.inverse_depth;
  std::size_t cell = 0;
  for (std::int32_t y0 = 0; y0 < picture.height; y0 += side) {
    start_columns(input, y0, columns);
    for (std::int32_t v = 0; v < side && y0 + v < picture.height; ++v) {
      const float* row = picture.row(y0 + v);
      if (input.mask.data == nullptr) {
        add_row(row, picture.width, v, columns, [](std::int32_t) noexcept { return true; });
      } else {
        const std::uint16_t* mask = input.mask.row(y0 + v);
        add_row(row, picture.width, v, columns, [mask](std::int32_t x) noexcept { return mask[x] == 0; });
      }
    }
    for (std::int32_t x0 = 0; x0 < picture.width; x0 += side, ++cell) {
      const InverseDepthMoments local = sum_columns(columns, x0);
      const auto reference = static_cast<double>(columns.reference[static_cast<std::size_t>(x0)]);
      cells[cell] = with_reference(local, reference).seen_from(-x0, -y0);
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
