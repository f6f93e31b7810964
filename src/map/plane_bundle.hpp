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

/// Sums over bundles in one leaf, eight of them in one vector.
struct BundleSums {
  using Eight = std::int32_t __attribute__((vector_size(32)));

  Eight sum = {};
  std::int64_t z = 0, residual = 0;
  std::int32_t readings = 0;

  /// Adds readings that stand together at quanta i, j, k.
  void add(std::int32_t i, std::int32_t j, std::int32_t k, std::int32_t more, std::int64_t squares) noexcept {
    using Place = std::int32_t __attribute__((vector_size(16)));
    using R = detail::PlaneRun;
    static_assert(R::xx == 0 && R::xy == 1 && R::zz == 2 && R::x == 3 && R::yy == 4 && R::yz == 5 &&
                  R::xz == 6 && R::y == 7);
    constexpr std::int32_t middle = plane_row::leaf_side / 2;
    // x, y, z from the leaf's centre, and 1.
    const Place place = (Place{i, j, k, middle + 1} & (plane_row::leaf_side - 1)) - middle;
    sum += more * __builtin_shufflevector(place, place, 0, 0, 2, 0, 1, 1, 0, 1) *
           __builtin_shufflevector(place, place, 0, 1, 2, 3, 1, 2, 2, 3);
    z += more * place[2];
    residual += squares;
    readings += more;
  }

  void add_to(detail::PlaneRun& run) const noexcept {
    Eight all;
    __builtin_memcpy(&all, run.sum, sizeof all);
    all += sum;
    __builtin_memcpy(run.sum, &all, sizeof all);
    run.z += z;
    run.residual += residual;
    run.readings += readings;
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
