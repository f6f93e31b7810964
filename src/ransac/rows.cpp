// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/rows.hpp"

#include <cstddef>

namespace straightedge::ransac {
namespace {

float fold(float (&sums)[row_lanes]) noexcept {
  for (std::uint32_t half = row_lanes / 2; half > 0; half /= 2)
    for (std::uint32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

/// Four neighbouring partial sums, as many as a plain processor keeps in its registers beside the plane, and
/// one register of four floats for others. `row`: the first of their rows in each group.
void sum_quad(const Rows& rows, std::uint32_t row, const Coefficients& plane, float* sums) noexcept {
  const Coefficients k = plane;
  const float *x = rows.x + row, *y = rows.y + row, *z = rows.z + row, *w = rows.w + row;
  const auto cost = [&](int l) noexcept {
    const float e = (k.x * x[l] + k.y * y[l]) + (k.z * z[l] + k.w * w[l]);
    const float squared = e * e;
    return squared < 1 ? squared : 1;
  };
  float s0 = 0, s1 = 0, s2 = 0, s3 = 0;
  for (std::uint32_t i = 0; i < rows.count; i += row_lanes) {
    s0 += cost(0);
    s1 += cost(1);
    s2 += cost(2);
    s3 += cost(3);
    x += row_lanes;
    y += row_lanes;
    z += row_lanes;
    w += row_lanes;
  }
  sums[0] = s0;
  sums[1] = s1;
  sums[2] = s2;
  sums[3] = s3;
}

}  // namespace

float msac_cost(const Rows& rows, const Coefficients& plane) noexcept {
  float sums[row_lanes];
  for (std::uint32_t first = 0; first < row_lanes; first += 4) {
    sum_quad(rows, first, plane, &sums[first]);
  }
  return fold(sums);
}

std::uint32_t count_inliers(const Rows& rows, std::uint32_t readings, const Coefficients& plane) noexcept {
  const float *x = rows.x, *y = rows.y, *z = rows.z, *w = rows.w;
  const Coefficients k = plane;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < rows.count; ++i) {
    const float e = (k.x * x[i] + k.y * y[i]) + (k.z * z[i] + k.w * w[i]);
    count += e * e < 1 ? 1U : 0U;
  }
  return count - (rows.count - readings);
}

}  // namespace straightedge::ransac
