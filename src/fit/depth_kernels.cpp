// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_kernels.hpp"

#include "base/kernel_set.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t pixels = DepthChoice::side * DepthChoice::side;
constexpr std::int32_t columns = 32;  // that are summed at once: their sums lie on the stack
constexpr std::int32_t band = 4;      // rows that are summed at once

void invert(const std::uint16_t* raw, std::int32_t width, float scale, float* inverse) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    // 0/1 where there is no reading: a division without a branch around it goes many at a time.
    const std::int32_t units = raw[x];
    const std::int32_t missing = units == 0 ? 1 : 0;
    inverse[x] = scale * static_cast<float>(1 - missing) / static_cast<float>(units + missing);
  }
}

struct ColumnSums {
  float reading[band][columns];  // of the rows at hand, 0 where there is none
  double q[columns], vq[columns], qq[columns];
  std::int32_t n[columns];
};

void take_row(const float* row, std::int32_t width, float* reading, std::int32_t* n) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    reading[x] = row[x] > 0 ? row[x] : 0.0F;
    n[x] += static_cast<std::int32_t>(row[x] > 0);
  }
}

/// Adds four rows, the first of which is row v of the cells.
void add_rows(const DepthRows& rows, std::int32_t width, double v, ColumnSums& sums) noexcept {
  for (std::int32_t i = 0; i < band; ++i) {
    take_row(rows.first + i * rows.stride, width, sums.reading[i], sums.n);
  }
  for (std::int32_t x = 0; x < width; ++x) {
    const double q0 = static_cast<double>(sums.reading[0][x]), q1 = static_cast<double>(sums.reading[1][x]);
    const double q2 = static_cast<double>(sums.reading[2][x]), q3 = static_cast<double>(sums.reading[3][x]);
    const double q = (q0 + q1) + (q2 + q3);
    sums.q[x] += q;
    sums.vq[x] += v * q + ((q1 + 2 * q2) + 3 * q3);
    sums.qq[x] += (q0 * q0 + q1 * q1) + (q2 * q2 + q3 * q3);
  }
}

DepthCellSums sum_columns(const ColumnSums& sums, std::int32_t first, std::int32_t side) noexcept {
  DepthCellSums cell;
  for (std::int32_t i = 0; i < side; i += band) {
    const double* q = sums.q + first + i;
    const double* vq = sums.vq + first + i;
    const double* qq = sums.qq + first + i;
    const std::int32_t* n = sums.n + first + i;
    const double sum = (q[0] + q[1]) + (q[2] + q[3]);
    cell.q += sum;
    cell.uq += i * sum + ((q[1] + 2 * q[2]) + 3 * q[3]);
    cell.vq += (vq[0] + vq[1]) + (vq[2] + vq[3]);
    cell.qq += (qq[0] + qq[1]) + (qq[2] + qq[3]);
    cell.n += (n[0] + n[1]) + (n[2] + n[3]);
  }
  return cell;
}

void sum_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, DepthCellSums* out) noexcept {
  ColumnSums sums;
  for (std::int32_t cell = 0; cell < cells; cell += columns / side) {
    const std::int32_t left = cells - cell, at_once = left < columns / side ? left : columns / side;
    const std::int32_t width = at_once * side;
    for (std::int32_t x = 0; x < columns; ++x) {
      sums.q[x] = sums.vq[x] = sums.qq[x] = 0;
      sums.n[x] = 0;
    }
    for (std::int32_t v = 0; v < side; v += band) {
      add_rows({corner.first + v * corner.stride + cell * side, corner.stride}, width, v, sums);
    }
    for (std::int32_t i = 0; i < at_once; ++i) out[cell + i] = sum_columns(sums, i * side, side);
  }
}

DepthBlockCounts label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept {
  DepthBlockCounts counts;
  const float slope = static_cast<float>(block.along), limit = block.limit;
  const std::uint16_t label = block.label;
  const std::int32_t width = block.width;
  for (std::int32_t y = 0; y < block.height; ++y) {
    const float* q = block.rows.first + y * block.rows.stride;
    std::uint16_t* out = labels + y * stride;
    const float first = static_cast<float>(block.at + block.down * y);
    std::int32_t readings = 0, labelled = 0;
    for (std::int32_t x = 0; x < width; ++x) {
      const float r = q[x] - (first + slope * static_cast<float>(x));
      const bool reads = q[x] > 0;
      const bool fits = (r < limit) & (r > -limit) & reads;
      out[x] = fits ? label : std::uint16_t{0};
      readings += reads ? 1 : 0;
      labelled += fits ? 1 : 0;
    }
    counts.labelled += labelled;
    counts.rows_missed |= (readings != labelled ? 1U : 0U) << static_cast<std::uint32_t>(y);
  }
  return counts;
}

/// A number for each of the 4x4 pixels.
struct Lanes {
  float of[pixels];
};

struct Nearest {
  Lanes distance, next;
  std::int32_t chosen[pixels];
};

/// u and v from the corner.
void nearest(const DepthChoice& pixel, const Lanes& u, const Lanes& v, const Lanes& q,
             Nearest& best) noexcept {
  for (std::int32_t i = 0; i < pixels; ++i) {
    best.distance.of[i] = best.next.of[i] = 1e30F;
    best.chosen[i] = 0;
  }
  for (std::int32_t k = 0; k < pixel.planes; ++k) {
    const float at = pixel.at[k], along = pixel.along[k], down = pixel.down[k];
    for (std::int32_t i = 0; i < pixels; ++i) {
      const float r = q.of[i] - ((at + along * u.of[i]) + down * v.of[i]);
      const float distance = r < 0 ? -r : r;
      const float before = best.distance.of[i], next = best.next.of[i];
      const float further = distance < before ? before : distance;
      best.next.of[i] = further < next ? further : next;
      best.distance.of[i] = distance < before ? distance : before;
      const std::int32_t nearer = static_cast<std::int32_t>(distance < before);
      best.chosen[i] += nearer * (k + 1 - best.chosen[i]);
    }
  }
}

/// The mean of the 3x3 pixels around each one that lie on its surface.
void average(const DepthChoice& pixel, const Lanes& limit, Lanes& u, Lanes& v, Lanes& q) noexcept {
  Lanes n{}, right{}, down{}, sum{};
  for (std::int32_t j = 0; j < 3; ++j) {
    for (std::int32_t i = 0; i < 3; ++i) {
      Lanes other;
      for (std::int32_t y = 0; y < DepthChoice::side; ++y) {
        const float* row = pixel.around + (y + j) * DepthChoice::stride + i;
        for (std::int32_t x = 0; x < DepthChoice::side; ++x) other.of[y * DepthChoice::side + x] = row[x];
      }
      const float dx = static_cast<float>(i - 1), dy = static_cast<float>(j - 1);
      for (std::int32_t k = 0; k < pixels; ++k) {
        const float r = other.of[k] - q.of[k];
        const bool counts = (other.of[k] > 0) & (r <= limit.of[k]) & (r >= -limit.of[k]);
        const float one = static_cast<float>(static_cast<std::int32_t>(counts));
        n.of[k] += one;
        right.of[k] += dx * one;
        down.of[k] += dy * one;
        sum.of[k] += one * other.of[k];
      }
    }
  }
  for (std::int32_t k = 0; k < pixels; ++k) {
    const float count = n.of[k] > 1 ? n.of[k] : 1.0F;
    u.of[k] += right.of[k] / count;
    v.of[k] += down.of[k] / count;
    q.of[k] = sum.of[k] / count;
  }
}

void choose(const DepthChoice& pixel, std::int32_t* chosen) noexcept {
  constexpr float beyond_doubt = 4, same_surface = 8;
  Lanes u, v, q, noise, limit;
  for (std::int32_t y = 0; y < DepthChoice::side; ++y) {
    const float* row = pixel.around + (y + 1) * DepthChoice::stride + 1;
    for (std::int32_t x = 0; x < DepthChoice::side; ++x) {
      u.of[y * DepthChoice::side + x] = static_cast<float>(x);
      v.of[y * DepthChoice::side + x] = static_cast<float>(y);
      q.of[y * DepthChoice::side + x] = row[x];
    }
  }
  std::int32_t reads[pixels];
  for (std::int32_t i = 0; i < pixels; ++i) {
    const float of_square = pixel.noise_of_square * (q.of[i] * q.of[i]);
    noise.of[i] = of_square > pixel.noise ? of_square : pixel.noise;
    limit.of[i] = same_surface * noise.of[i];
    reads[i] = q.of[i] > 0 ? 1 : 0;
  }
  Nearest found;
  nearest(pixel, u, v, q, found);
  std::int32_t doubts = 0;
  std::int32_t doubt[pixels];
  for (std::int32_t i = 0; i < pixels; ++i) {
    const float ahead = found.next.of[i] - found.distance.of[i];
    doubt[i] = ahead < beyond_doubt * noise.of[i] ? reads[i] : 0;
    doubts += doubt[i];
  }
  Lanes distance = found.distance;
  for (std::int32_t i = 0; i < pixels; ++i) chosen[i] = found.chosen[i];
  if (doubts > 0) {
    average(pixel, limit, u, v, q);
    nearest(pixel, u, v, q, found);
    for (std::int32_t i = 0; i < pixels; ++i) {
      chosen[i] = doubt[i] != 0 ? found.chosen[i] : chosen[i];
      distance.of[i] = doubt[i] != 0 ? found.distance.of[i] : distance.of[i];
    }
  }
  for (std::int32_t i = 0; i < pixels; ++i) {
    chosen[i] = distance.of[i] < pixel.sigmas * noise.of[i] ? chosen[i] * reads[i] : 0;
  }
}

constexpr std::uint32_t bit[DepthSurfaces::step] = {
    1U << 0U, 1U << 1U, 1U << 2U,  1U << 3U,  1U << 4U,  1U << 5U,  1U << 6U,  1U << 7U,
    1U << 8U, 1U << 9U, 1U << 10U, 1U << 11U, 1U << 12U, 1U << 13U, 1U << 14U, 1U << 15U};

void near(const DepthSurfaces& s, float x, float y, float q, float limit, std::uint32_t* near) noexcept {
  const float xx = x * x, xy = x * y, yy = y * y;
  for (std::int32_t first = 0; first < s.count; first += DepthSurfaces::step, ++near) {
    const float *c = s.c + first, *cx = s.x + first, *cy = s.y + first;
    const float *cxx = s.xx + first, *cxy = s.xy + first, *cyy = s.yy + first;
    std::uint32_t bits = 0;
    for (std::int32_t k = 0; k < DepthSurfaces::step; ++k) {
      const float at = (c[k] + cx[k] * x) + (cy[k] * y + cxx[k] * xx) + (cxy[k] * xy + cyy[k] * yy);
      const float off = q - at;
      bits |= off * off <= limit ? bit[k] : 0U;
    }
    *near = bits;
  }
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const DepthKernels STRAIGHTEDGE_OF_SET(_depth_kernels) = {
    STRAIGHTEDGE_KERNEL_SET::invert, STRAIGHTEDGE_KERNEL_SET::sum_cells, STRAIGHTEDGE_KERNEL_SET::label_block,
    STRAIGHTEDGE_KERNEL_SET::choose, STRAIGHTEDGE_KERNEL_SET::near};

}  // namespace straightedge
