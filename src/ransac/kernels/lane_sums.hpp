// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/lanes.hpp"
#include "straightedge/plane_search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// The sum of partial sums, the halves onto one another until one is left.
[[maybe_unused]] inline float fold(float (&sums)[search_lanes]) noexcept {
  static_assert(search_lanes == 16);
  for (std::int32_t l = 0; l < 8; ++l) sums[l] += sums[l + 8];
  for (std::int32_t l = 0; l < 4; ++l) sums[l] += sums[l + 4];
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

struct PartialSums {
  float of[11][search_lanes];

  SearchSums folded() noexcept {
    return {fold(of[0]), fold(of[1]), fold(of[2]), fold(of[3]), fold(of[4]), fold(of[5]),
            fold(of[6]), fold(of[7]), fold(of[8]), fold(of[9]), fold(of[10])};
  }
};

/// Some lanes of them, in registers.
struct LaneSums {
  Lanes n = all(0), u = all(0), v = all(0), uu = all(0), uv = all(0), vv = all(0);
  Lanes r = all(0), ur = all(0), vr = all(0), rr = all(0), ww = all(0);

  /// Readings whose mark is 1, not 0.
  void add(const Lanes& mark, const Lanes& x, const Lanes& y, const Lanes& residual,
           const Lanes& w) noexcept {
    const Lanes mx = mark * x, my = mark * y, mr = mark * residual;
    n += mark;
    u += mx;
    v += my;
    uu += mx * x;
    uv += mx * y;
    vv += my * y;
    r += mr;
    ur += mr * x;
    vr += mr * y;
    rr += mr * residual;
    ww += mark * (w * w);
  }

  void store_to(PartialSums& sums, std::int32_t first) const noexcept {
    const Lanes* const from[] = {&n, &u, &v, &uu, &uv, &vv, &r, &ur, &vr, &rr, &ww};
    for (int i = 0; i < 11; ++i) store(sums.of[i] + first, *from[i]);
  }
};

}  // namespace
}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
