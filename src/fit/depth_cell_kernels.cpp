// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Four cells that make one each, and how far their means are from its.
struct JoinedCells {
  static constexpr std::int32_t most = 16;
  float n[4][most], away[3][4][most];

  /// Number k of the four, of each of them.
  static const float* part(const DepthCellRows& from, std::ptrdiff_t below, int kind, int k) noexcept {
    return from.first + kind * from.apart + (k & 1) + (k >> 1) * below;
  }
  void join(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t count,
            const DepthCellRows& out) noexcept {
    float inverse[most];
    float* sum = out.first;
    for (int k = 0; k < 4; ++k) {
      const float* of = part(from, below, 0, k);
      for (std::int32_t i = 0; i < count; ++i) n[k][i] = of[2 * i];
    }
    for (std::int32_t i = 0; i < count; ++i) {
      const float all_four = (n[0][i] + n[1][i]) + (n[2][i] + n[3][i]);
      inverse[i] = 1 / (all_four > 0 ? all_four : 1.0F);
      sum[i] = all_four;
    }
    for (int kind = 1; kind <= 3; ++kind)
      join_means(from, below, kind, count, inverse, sum + kind * out.apart);
    constexpr int first[6] = {0, 0, 1, 0, 1, 2}, second[6] = {0, 1, 1, 2, 2, 2};
    for (int p = 0; p < 6; ++p) {
      join_products(from, below, p + 4, count, away[first[p]], away[second[p]], sum + (p + 4) * out.apart);
    }
  }

 private:
  void join_means(const DepthCellRows& from, std::ptrdiff_t below, int kind, std::int32_t count,
                  const float* inverse, float* __restrict means) noexcept {
    const float *a = part(from, below, kind, 0), *b = part(from, below, kind, 2);
    float(&d)[4][most] = away[kind - 1];
    for (std::int32_t i = 0; i < count; ++i) {
      const float x0 = a[2 * i], x1 = a[2 * i + 1], x2 = b[2 * i], x3 = b[2 * i + 1];
      const float mean = ((n[0][i] * x0 + n[1][i] * x1) + (n[2][i] * x2 + n[3][i] * x3)) * inverse[i];
      d[0][i] = x0 - mean;
      d[1][i] = x1 - mean;
      d[2][i] = x2 - mean;
      d[3][i] = x3 - mean;
      means[i] = mean;
    }
  }
  void join_products(const DepthCellRows& from, std::ptrdiff_t below, int kind, std::int32_t count,
                     const float (&d)[4][most], const float (&e)[4][most],
                     float* __restrict sums) const noexcept {
    const float *a = part(from, below, kind, 0), *b = part(from, below, kind, 2);
    for (std::int32_t i = 0; i < count; ++i) {
      const float within = (a[2 * i] + a[2 * i + 1]) + (b[2 * i] + b[2 * i + 1]);
      const float upper = n[0][i] * (d[0][i] * e[0][i]) + n[1][i] * (d[1][i] * e[1][i]);
      const float lower = n[2][i] * (d[2][i] * e[2][i]) + n[3][i] * (d[3][i] * e[3][i]);
      sums[i] = within + (upper + lower);
    }
  }
};

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
  JoinedCells joined;
  for (std::int32_t first = 0; first < cells; first += JoinedCells::most) {
    const std::int32_t left = cells - first, count = left < JoinedCells::most ? left : JoinedCells::most;
    joined.join({from.first + 2 * first, from.apart}, below, count, {out.first + first, out.apart});
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
