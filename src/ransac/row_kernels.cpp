// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels.hpp"
#include "ransac/rows.hpp"

namespace straightedge::plain {
namespace {

constexpr std::uint32_t lanes = ransac_lanes;

/// Four planes of a batch: as many as a plain processor keeps in its registers.
void quad_costs(const RansacRows& rows, const RansacBatch& planes, std::uint32_t first, float* costs) noexcept {
  const float *kx = planes.x + first, *ky = planes.y + first, *kz = planes.z + first, *kw = planes.w + first;
  float s[4] = {0, 0, 0, 0};
  for (std::uint32_t i = 0; i < rows.count; ++i) {
    const float x = rows.x[i], y = rows.y[i], z = rows.z[i], w = rows.w[i];
    for (int h = 0; h < 4; ++h) {
      const float e = (kx[h] * x + ky[h] * y) + (kz[h] * z + kw[h] * w);
      const float squared = e * e;
      s[h] += squared < 1 ? squared : 1;
    }
  }
  for (int h = 0; h < 4; ++h) costs[first + static_cast<std::uint32_t>(h)] = s[h];
}

/// A row as it counts in the sums: zeros beyond the limit.
struct Change {
  float s[lanes], t[lanes], w[lanes], e[lanes];
};

void add(float (&sums)[lanes], const float (&a)[lanes], const float (&b)[lanes]) noexcept {
  for (std::uint32_t l = 0; l < lanes; ++l) sums[l] += a[l] * b[l];
}

float fold(float (&sums)[lanes]) noexcept {
  for (std::uint32_t half = lanes / 2; half > 0; half /= 2)
    for (std::uint32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

}  // namespace

void batch_costs(const RansacRows& rows, const RansacBatch& planes, float* costs) noexcept {
  for (std::uint32_t first = 0; first < lanes; first += 4) quad_costs(rows, planes, first, costs);
}

float row_cost(const RansacRows& rows, const RansacCoefficients& plane) noexcept {
  return ransac::msac_cost(rows, plane);
}

std::uint32_t count_rows(const RansacRows& rows, const RansacCoefficients& plane) noexcept {
  return ransac::count_inliers(rows, rows.count, plane);
}

RansacChangeSums sum_changes(const RansacRows& rows, const RansacCoefficients& plane, const float* s,
                             const float* t, float limit) noexcept {
  const RansacCoefficients k = plane;
  float sums[9][lanes] = {};
  for (std::uint32_t i = 0; i < rows.count; i += lanes) {
    Change c;
    for (std::uint32_t l = 0; l < lanes; ++l) {
      const std::uint32_t at = i + l;
      const float e = (k.x * rows.x[at] + k.y * rows.y[at]) + (k.z * rows.z[at] + k.w * rows.w[at]);
      const bool inside = e * e < limit;
      c.s[l] = inside ? s[at] : 0;
      c.t[l] = inside ? t[at] : 0;
      c.w[l] = inside ? rows.w[at] : 0;
      c.e[l] = inside ? e : 0;
    }
    add(sums[0], c.s, c.s);
    add(sums[1], c.s, c.t);
    add(sums[2], c.s, c.w);
    add(sums[3], c.t, c.t);
    add(sums[4], c.t, c.w);
    add(sums[5], c.w, c.w);
    add(sums[6], c.s, c.e);
    add(sums[7], c.t, c.e);
    add(sums[8], c.w, c.e);
  }
  return {fold(sums[0]), fold(sums[1]), fold(sums[2]), fold(sums[3]), fold(sums[4]),
          fold(sums[5]), fold(sums[6]), fold(sums[7]), fold(sums[8])};
}

}  // namespace straightedge::plain
