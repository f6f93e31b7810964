// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Whether a reading of the row is not the plane's.
bool label_row(const float* q, const DepthBlock& block, float first, float slope,
               std::uint16_t* __restrict out) noexcept {
  const float limit = block.limit;
  const std::uint16_t label = block.label;
  std::int32_t missed = 0;
  for (std::int32_t x = 0; x < block.width; ++x) {
    const float r = q[x] - (first + slope * static_cast<float>(x));
    const bool reads = q[x] > 0, near = (r < limit) & (r > -limit);
    out[x] = (near & reads) ? label : std::uint16_t{0};
    missed |= (reads & !near) ? 1 : 0;
  }
  return missed != 0;
}

/// Takes the readings of row v without a label out of the sums.
void subtract_missed(const float* q, const std::uint16_t* labels, const DepthBlock& block, double v,
                     double* sums) noexcept {
  // Sums of whole numbers are exact in any order.
  double n = 0, u = 0, uu = 0, sum = 0, uq = 0, vq = 0, qq = 0;
  for (std::int32_t x = 0; x < block.width; ++x) {
    if (!(q[x] > 0) || labels[x] != 0) continue;
    const double column = block.left + x, reading = static_cast<double>(q[x]);
    n += 1;
    u += column;
    uu += column * column;
    sum += reading;
    uq += column * reading;
    vq += v * reading;
    qq += reading * reading;
  }
  const double missed[] = {n, u, v * n, uu, v * u, v * v * n, sum, uq, vq, qq};
  for (int i = 0; i < 10; ++i) sums[i] -= missed[i];
}

}  // namespace

void label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride,
                 double* sums) noexcept {
  const float slope = static_cast<float>(block.along);
  for (std::int32_t y = 0; y < block.height; ++y, labels += stride) {
    const float* q = block.rows.first + y * block.rows.stride;
    const float first = static_cast<float>(block.at + block.down * y);
    if (label_row(q, block, first, slope, labels)) subtract_missed(q, labels, block, block.top + y, sums);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
