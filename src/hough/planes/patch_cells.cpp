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

/// Two cells beside one another.
constexpr std::int32_t pair = 2 * side;

/// Pairs of cells, rows `stride` floats apart.
struct PairPixels {
  const float* first = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Whole pairs without a mask are read where they are; others are copied, with 0 where no reading takes part.
PairPixels pixels_of(const DepthInput& input, std::int32_t x0, std::int32_t y0,
                     std::array<float, pair * side>& copy) noexcept {
  const ImageView<const float>& picture = input.inverse_depth;
  const bool whole = x0 + pair <= picture.width && y0 + side <= picture.height;
  const bool in_floats = picture.stride % static_cast<std::ptrdiff_t>(sizeof(float)) == 0;
  if (whole && in_floats && input.mask.data == nullptr) {
    return {picture.row(y0) + x0, picture.stride / static_cast<std::ptrdiff_t>(sizeof(float))};
  }
  copy = {};
  const std::int32_t columns = x0 + pair < picture.width ? pair : picture.width - x0;
  const std::int32_t rows = y0 + side < picture.height ? side : picture.height - y0;
  for (std::int32_t v = 0; v < rows; ++v) {
    const float* from = picture.row(y0 + v) + x0;
    float* to = copy.data() + v * pair;
    const std::uint16_t* mask = input.mask.data == nullptr ? nullptr : input.mask.row(y0 + v) + x0;
    for (std::int32_t u = 0; u < columns; ++u) {
      const std::int32_t free = -static_cast<std::int32_t>(mask == nullptr || mask[u] == 0);
      to[u] = std::bit_cast<float>(std::bit_cast<std::int32_t>(from[u]) & free);
    }
  }
  return {copy.data(), pair};
}

/// Does the mask leave out all pixels of a pair of whole cells? Masks leave out most of a picture.
bool all_masked(const DepthInput& input, std::int32_t x0, std::int32_t y0) noexcept {
  const ImageView<const std::uint16_t>& mask = input.mask;
  if (mask.data == nullptr || x0 + pair > mask.width || y0 + side > mask.height) return false;
  std::uint32_t least = 1;
  for (std::int32_t v = 0; v < side; ++v) {
    const std::uint16_t* row = mask.row(y0 + v) + x0;
    for (std::int32_t u = 0; u < pair; ++u) least &= row[u] != 0 ? 1U : 0U;
  }
  return least != 0;
}

/// Counts and sums of places, q left out; u and v from the cell's corner.
InverseDepthMoments places_of(const SquareSums& square) noexcept {
  if (square.whole) return {.n = 64, .u = 224, .v = 224, .uu = 1120, .uv = 784, .vv = 1120};
  std::int32_t n = 0, u_sum = 0, v_sum = 0, uu = 0, uv = 0, vv = 0;
  for (std::int32_t u = 0; u < side; ++u) {
    const std::size_t seen = square.seen[u];
    const std::int32_t count = row_sums.count[seen];
    n += count;
    u_sum += u * count;
    uu += u * u * count;
    v_sum += row_sums.v[seen];
    uv += u * row_sums.v[seen];
    vv += row_sums.vv[seen];
  }
  InverseDepthMoments m;
  m.n = n;
  m.u = u_sum;
  m.v = v_sum;
  m.uu = uu;
  m.uv = uv;
  m.vv = vv;
  return m;
}

/// With q counted from 0 and pixels from the picture's corner.
InverseDepthMoments moments_of(const SquareSums& square, std::int32_t x0, std::int32_t y0) noexcept {
  InverseDepthMoments m = places_of(square);
  const auto reference = static_cast<double>(square.reference);
  const auto q = static_cast<double>(square.q);
  m.q = q + reference * m.n;
  m.uq = static_cast<double>(square.uq) + reference * m.u;
  m.vq = static_cast<double>(square.vq) + reference * m.v;
  m.qq = static_cast<double>(square.qq) + 2 * reference * q + reference * reference * m.n;
  return m.seen_from(-x0, -y0);
}

}  // namespace

void sum_cells(const DepthInput& input, const HoughPatchKernels& kernels,
               std::span<InverseDepthMoments> cells) noexcept {
  std::array<float, pair * side> copy;
  std::size_t cell = 0;
  for (std::int32_t y0 = 0; y0 < input.inverse_depth.height; y0 += side) {
    for (std::int32_t x0 = 0; x0 < input.inverse_depth.width; x0 += pair) {
      SquareSums sums[2];
      if (!all_masked(input, x0, y0)) {
        const PairPixels pixels = pixels_of(input, x0, y0, copy);
        kernels.sum_squares(pixels.first, pixels.stride, largest_reading, sums);
      }
      cells[cell++] = moments_of(sums[0], x0, y0);
      if (x0 + side < input.inverse_depth.width) cells[cell++] = moments_of(sums[1], x0 + side, y0);
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
