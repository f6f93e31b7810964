// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels.hpp"
#include "ransac/quad.hpp"
#include "ransac/rows.hpp"

namespace straightedge::plain {
namespace {

constexpr std::uint32_t lanes = ransac_lanes;

/// Four planes of a batch: as many as a plain processor keeps in its registers.
void quad_costs(const RansacRows& rows, const RansacBatch& planes, std::uint32_t first,
                float* costs) noexcept {
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

/// Rows that are looked at in one go.
constexpr std::uint32_t chunk = 32;

/// Rows from `first` on as they count in the sums: zeros beyond the limit.
struct Inliers {
  float s[chunk], t[chunk], w[chunk], e[chunk];
  std::uint32_t count;

  Inliers(const RansacRows& rows, const RansacCoefficients& k, const float* of_s, const float* of_t,
          float limit, std::uint32_t first) noexcept
      : count(rows.count - first < chunk ? rows.count - first : chunk) {
    const float *x = rows.x + first, *y = rows.y + first, *z = rows.z + first, *v = rows.w + first;
    const float *p = of_s + first, *q = of_t + first;
    const float kx = k.x, ky = k.y, kz = k.z, kw = k.w;
    for (std::uint32_t i = 0; i < count; ++i) {
      const float residual = (kx * x[i] + ky * y[i]) + (kz * z[i] + kw * v[i]);
      const bool inside = residual * residual < limit;
      s[i] = inside ? p[i] : 0;
      t[i] = inside ? q[i] : 0;
      w[i] = inside ? v[i] : 0;
      e[i] = inside ? residual : 0;
    }
  }
};

struct LaneSums {
  float of[9][lanes] = {};

  void add_quad(const Inliers& in, std::uint32_t l) noexcept {
    Quad ss, st, sw, tt, tw, ww, se, te, we;
    Quad* const all[] = {&ss, &st, &sw, &tt, &tw, &ww, &se, &te, &we};
    for (int k = 0; k < 9; ++k) all[k]->load(of[k] + l);
    for (std::uint32_t i = l; i < in.count; i += lanes) {
      const float *s = in.s + i, *t = in.t + i, *w = in.w + i, *e = in.e + i;
      ss.add(s, s);
      st.add(s, t);
      sw.add(s, w);
      tt.add(t, t);
      tw.add(t, w);
      ww.add(w, w);
      se.add(s, e);
      te.add(t, e);
      we.add(w, e);
    }
    for (int k = 0; k < 9; ++k) all[k]->store(of[k] + l);
  }
};

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
  LaneSums sums;
  for (std::uint32_t first = 0; first < rows.count; first += chunk) {
    const Inliers inliers(rows, plane, s, t, limit, first);
    for (std::uint32_t l = 0; l < lanes; l += 4) sums.add_quad(inliers, l);
  }
  auto& of = sums.of;
  return {fold(of[0]), fold(of[1]), fold(of[2]), fold(of[3]), fold(of[4]),
          fold(of[5]), fold(of[6]), fold(of[7]), fold(of[8])};
}

}  // namespace straightedge::plain
