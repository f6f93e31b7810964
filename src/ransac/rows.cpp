// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/rows.hpp"

namespace straightedge::ransac {
namespace {

float fold(float (&sums)[row_lanes]) noexcept {
  for (std::uint32_t half = row_lanes / 2; half > 0; half /= 2)
    for (std::uint32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

}  // namespace

float msac_cost(const Rows& rows, const Coefficients& plane) noexcept {
  float sums[row_lanes] = {};
  for (std::uint32_t i = 0; i < rows.count; i += row_lanes) {
    for (std::uint32_t l = 0; l < row_lanes; ++l) {
      const float e = (plane.x * rows.x[i + l] + plane.y * rows.y[i + l]) +
                      (plane.z * rows.z[i + l] + plane.w * rows.w[i + l]);
      const float squared = e * e;
      sums[l] += squared < 1 ? squared : 1;
    }
  }
  return fold(sums);
}

std::uint32_t count_inliers(const Rows& rows, std::uint32_t readings, const Coefficients& plane) noexcept {
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < rows.count; ++i) {
    const float e = (plane.x * rows.x[i] + plane.y * rows.y[i]) + (plane.z * rows.z[i] + plane.w * rows.w[i]);
    count += e * e < 1 ? 1U : 0U;
  }
  return count - (rows.count - readings);
}

}  // namespace straightedge::ransac
