// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "speed_loops.hpp"

namespace bench::speed::SPEED_LOOPS {
namespace {

constexpr std::size_t lanes = 16;

float sum_of(const float* partial) {
  float sum = 0;
  for (std::size_t l = 0; l < lanes; ++l) sum += partial[l];
  return sum;
}

}  // namespace

float score_plane(const float* x, const float* y, const float* z, std::size_t count, const float* plane) {
  const float a = plane[0], b = plane[1], c = plane[2], d = plane[3];
  float cost[lanes] = {};
  for (std::size_t i = 0; i + lanes <= count; i += lanes) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const float e = a * x[i + l] + b * y[i + l] + c * z[i + l] - d;
      const float square = e * e;
      cost[l] += square < 1 ? square : 1;
    }
  }
  return sum_of(cost);
}

void sum_products(const float* x, const float* y, const float* z, std::size_t count, float* products) {
  float xx[lanes] = {}, xy[lanes] = {}, xz[lanes] = {}, yy[lanes] = {}, yz[lanes] = {}, zz[lanes] = {};
  for (std::size_t i = 0; i + lanes <= count; i += lanes) {
    for (std::size_t l = 0; l < lanes; ++l) {
      xx[l] += x[i + l] * x[i + l];
      xy[l] += x[i + l] * y[i + l];
      xz[l] += x[i + l] * z[i + l];
      yy[l] += y[i + l] * y[i + l];
      yz[l] += y[i + l] * z[i + l];
      zz[l] += z[i + l] * z[i + l];
    }
  }
  const float* const sums[] = {xx, xy, xz, yy, yz, zz};
  for (std::size_t k = 0; k < 6; ++k) products[k] = sum_of(sums[k]);
}

}  // namespace bench::speed::SPEED_LOOPS
