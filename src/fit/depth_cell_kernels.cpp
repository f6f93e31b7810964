// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "depth_cell_kernels.hpp"

#include "base/lane_pairs.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// A number of each of the four cells that make one, of as many as lanes.
struct OfFour {
  Lanes of[4];

  OfFour() noexcept = default;
  OfFour(const float* upper, std::ptrdiff_t below) noexcept {
    const Pairs above(upper), beneath(upper + below);
    of[0] = above.first;
    of[1] = above.second;
    of[2] = beneath.first;
    of[3] = beneath.second;
  }
  Lanes sum() const noexcept { return (of[0] + of[1]) + (of[2] + of[3]); }
};

Lanes sum_of_products(const OfFour& a, const OfFour& b) noexcept {
  return (a.of[0] * b.of[0] + a.of[1] * b.of[1]) + (a.of[2] * b.of[2] + a.of[3] * b.of[3]);
}

OfFour products(const OfFour& a, const OfFour& b) noexcept {
  OfFour product;
  for (int k = 0; k < 4; ++k) product.of[k] = a.of[k] * b.of[k];
  return product;
}

/// As many cells as lanes.
void join_some(const DepthCellRows& from, std::ptrdiff_t below, const DepthCellRows& out) noexcept {
  const auto number = [&](int kind) noexcept { return OfFour(from.first + kind * from.apart, below); };
  const auto put = [&](int kind, const Lanes& x) noexcept { store(out.first + kind * out.apart, x); };
  const OfFour n = number(0);
  const Lanes readings = n.sum(), inverse = all(1) / (readings > all(0) ? readings : all(1));
  put(0, readings);
  OfFour away[3];  // the four means from that of all
  for (int i = 0; i < 3; ++i) {
    const OfFour means = number(1 + i);
    const Lanes mean = sum_of_products(n, means) * inverse;
    put(1 + i, mean);
    for (int k = 0; k < 4; ++k) away[i].of[k] = means.of[k] - mean;
  }
  constexpr int first[6] = {0, 0, 1, 0, 1, 2}, second[6] = {0, 1, 1, 2, 2, 2};
  for (int p = 0; p < 6; ++p)
    put(4 + p, number(4 + p).sum() + sum_of_products(n, products(away[first[p]], away[second[p]])));
}

/// Fewer cells than lanes.
void join_few(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t cells,
              const DepthCellRows& out) noexcept {
  constexpr std::ptrdiff_t row = 2 * lanes;
  float four[DepthCellRows::kinds * 2 * row] = {}, joined[DepthCellRows::kinds * lanes];
  for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) {
    const float* upper = from.first + kind * from.apart;
    for (std::int32_t i = 0; i < 2 * cells; ++i) {
      four[2 * kind * row + i] = upper[i];
      four[(2 * kind + 1) * row + i] = upper[below + i];
    }
  }
  join_some({four, 2 * row}, row, {joined, lanes});
  for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind)
    for (std::int32_t i = 0; i < cells; ++i) out.first[kind * out.apart + i] = joined[kind * lanes + i];
}

}  // namespace

void keep_readings(const float* inverse, const std::uint16_t* mask, std::int32_t width, float most,
                   float* __restrict kept) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    const bool good = (inverse[x] > 0) & (inverse[x] <= most);
    kept[x] = good ? inverse[x] : 0.0F;
  }
  if (mask == nullptr) return;
  for (std::int32_t x = 0; x < width; ++x) kept[x] = mask[x] == 0 ? kept[x] : 0.0F;
}

void join_cells(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t cells,
                const DepthCellRows& out) noexcept {
  const auto join = [&](std::int32_t first) noexcept {
    join_some({from.first + 2 * first, from.apart}, below, {out.first + first, out.apart});
  };
  std::int32_t first = 0;
  for (; first + lanes <= cells; first += lanes) join(first);
  if (lanes == 1 || first == cells) return;
  if (cells > lanes) {
    join(cells - lanes);  // some of them once more
  } else {
    join_few(from, below, cells, out);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
