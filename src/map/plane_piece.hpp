// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/plane_row.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Adds a reading at quanta i, j, k.
inline void add_reading(detail::PlaneRun& run, std::int32_t i, std::int32_t j, std::int32_t k,
                        std::int32_t residual) noexcept {
  using R = detail::PlaneRun;
  const auto in_leaf = [](std::int32_t at) {
    return (at & (plane_row::leaf_side - 1)) - plane_row::leaf_side / 2;
  };
  const std::int32_t x = in_leaf(i), y = in_leaf(j), z = in_leaf(k);
  run.sum[R::xx] += x * x;
  run.sum[R::xy] += x * y;
  run.sum[R::xz] += x * z;
  run.sum[R::yy] += y * y;
  run.sum[R::yz] += y * z;
  run.sum[R::zz] += z * z;
  run.sum[R::x] += x;
  run.sum[R::y] += y;
  run.z += z;
  run.residual += std::int64_t{residual} * residual;
  run.readings += 1;
}

/// Adds `count` pixels, at most 16, from pixel n on.
inline void add_pixels(detail::PlaneRun& run, const PlaneRowPlaces& p, std::int32_t n,
                       std::int32_t count) noexcept {
  detail::PlaneRun sums = run;  // a copy of its own stays in registers
  for (std::int32_t at = p.guard + n; at < p.guard + n + count; ++at)
    add_reading(sums, p.i[at], p.j[at], p.k[at], p.residual[at]);
  run = sums;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
