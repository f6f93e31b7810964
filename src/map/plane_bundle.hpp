// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/plane_row.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Neither a value beyond the bounds nor NaN comes through: that becomes the bound.
inline double bounded(double x, double bound) noexcept {
  const double below = x < bound ? x : bound;
  return below > -bound ? below : -bound;
}

/// Adds readings that stand together at quanta i, j, k.
inline void add_bundle(detail::PlaneRun& run, std::int32_t i, std::int32_t j, std::int32_t k,
                       std::int32_t readings, std::int64_t residual) noexcept {
  using R = detail::PlaneRun;
  const auto in_leaf = [](std::int32_t at) {
    return (at & (plane_row::leaf_side - 1)) - plane_row::leaf_side / 2;
  };
  const std::int32_t x = in_leaf(i), y = in_leaf(j), z = in_leaf(k);
  const std::int32_t wx = readings * x, wy = readings * y, wz = readings * z;
  run.sum[R::xx] += wx * x;
  run.sum[R::xy] += wx * y;
  run.sum[R::zz] += wz * z;
  run.sum[R::x] += wx;
  run.sum[R::yy] += wy * y;
  run.sum[R::yz] += wy * z;
  run.sum[R::xz] += wx * z;
  run.sum[R::y] += wy;
  run.z += wz;
  run.residual += residual;
  run.readings += readings;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
