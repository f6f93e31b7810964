// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t columns = 32;  // that are summed at once: their sums lie on the stack
constexpr std::int32_t band = 4;      // rows that are summed at once

struct ColumnSums {
  float reading[band][columns];  // of the rows at hand, 0 where there is none
  double q[columns], vq[columns], qq[columns];
  std::int32_t n[columns];
};

void take_row(const float* row, std::int32_t width, float* __restrict reading) noexcept {
  for (std::int32_t x = 0; x < width; ++x) reading[x] = row[x] > 0 ? row[x] : 0.0F;
}

/// Adds four rows, the first of which is row v of the cells; the first band begins the sums.
template <bool first>
void add_rows(const DepthRows& rows, std::int32_t width, double v, ColumnSums& sums) noexcept {
  for (std::int32_t i = 0; i < band; ++i) take_row(rows.first + i * rows.stride, width, sums.reading[i]);
  for (std::int32_t x = 0; x < width; ++x) {
    const std::int32_t upper = (sums.reading[0][x] > 0 ? 1 : 0) + (sums.reading[1][x] > 0 ? 1 : 0);
    const std::int32_t lower = (sums.reading[2][x] > 0 ? 1 : 0) + (sums.reading[3][x] > 0 ? 1 : 0);
    sums.n[x] = (first ? 0 : sums.n[x]) + (upper + lower);
  }
  for (std::int32_t x = 0; x < width; ++x) {
    const double q0 = static_cast<double>(sums.reading[0][x]), q1 = static_cast<double>(sums.reading[1][x]);
    const double q2 = static_cast<double>(sums.reading[2][x]), q3 = static_cast<double>(sums.reading[3][x]);
    const double q = (q0 + q1) + (q2 + q3);
    sums.q[x] = (first ? 0 : sums.q[x]) + q;
    sums.vq[x] = (first ? 0 : sums.vq[x]) + (v * q + ((q1 + 2 * q2) + 3 * q3));
    sums.qq[x] = (first ? 0 : sums.qq[x]) + ((q0 * q0 + q1 * q1) + (q2 * q2 + q3 * q3));
  }
}

/// Sums of four columns beside one another each.
struct BandSums {
  static constexpr std::int32_t most = columns / band;
  double q[most], uq[most], vq[most], qq[most];
  std::int32_t n[most];

  void sum(const ColumnSums& of, std::int32_t bands) noexcept {
    for (std::int32_t i = 0; i < bands; ++i) {
      const double* x = of.q + band * i;
      q[i] = (x[0] + x[1]) + (x[2] + x[3]);
      uq[i] = (x[1] + 2 * x[2]) + 3 * x[3];
    }
    for (std::int32_t i = 0; i < bands; ++i) {
      const double* x = of.vq + band * i;
      vq[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
    for (std::int32_t i = 0; i < bands; ++i) {
      const double* x = of.qq + band * i;
      qq[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
    for (std::int32_t i = 0; i < bands; ++i) {
      const std::int32_t* x = of.n + band * i;
      n[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
  }
  DepthCellSums cell(std::int32_t first, std::int32_t bands) const noexcept {
    DepthCellSums sums;
    for (std::int32_t i = 0; i < bands; ++i) {
      sums.q += q[first + i];
      sums.uq += band * i * q[first + i] + uq[first + i];
      sums.vq += vq[first + i];
      sums.qq += qq[first + i];
      sums.n += n[first + i];
    }
    return sums;
  }
};

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

void sum_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, DepthCellSums* out) noexcept {
  ColumnSums sums;
  for (std::int32_t cell = 0; cell < cells; cell += columns / side) {
    const std::int32_t left = cells - cell, at_once = left < columns / side ? left : columns / side;
    const std::int32_t width = at_once * side;
    const float* const first = corner.first + cell * side;
    add_rows<true>({first, corner.stride}, width, 0, sums);
    for (std::int32_t v = band; v < side; v += band) {
      add_rows<false>({first + v * corner.stride, corner.stride}, width, v, sums);
    }
    const std::int32_t bands = side / band;
    BandSums of_bands;
    of_bands.sum(sums, at_once * bands);
    for (std::int32_t i = 0; i < at_once; ++i) out[cell + i] = of_bands.cell(i * bands, bands);
  }
}

void whole_cells(const DepthCellSums* sums, std::int32_t side, std::int32_t cells, float left, float top,
                 const DepthCellRows& out) noexcept {
  const float count = static_cast<float>(side * side), half = 0.5F * static_cast<float>(side - 1);
  // Of 0 to side − 1 the squared deviations from the mean, side times.
  const float spread = count * (count - 1) / 12;
  const double n = static_cast<double>(count), middle = static_cast<double>(half);
  float *readings = out.first, *u = readings + out.apart, *v = u + out.apart, *q = v + out.apart;
  float *uu = q + out.apart, *uv = uu + out.apart, *vv = uv + out.apart;
  float *uq = vv + out.apart, *vq = uq + out.apart, *qq = vq + out.apart;
  for (std::int32_t i = 0; i < cells; ++i) {
    const double mean = sums[i].q / n;
    readings[i] = count;
    u[i] = left + (static_cast<float>(i * side) + half);
    v[i] = top + half;
    q[i] = static_cast<float>(mean);
    uu[i] = vv[i] = spread;
    uv[i] = 0;
    uq[i] = static_cast<float>(sums[i].uq - middle * sums[i].q);
    vq[i] = static_cast<float>(sums[i].vq - middle * sums[i].q);
    qq[i] = static_cast<float>(sums[i].qq - mean * sums[i].q);
  }
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
