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

/// Where readings stand: quanta i, j, k, and BundleSums::one.
using BundlePlace = std::int32_t __attribute__((vector_size(16)));

inline BundlePlace place_of(const std::int32_t (&at)[4]) noexcept {
  BundlePlace place;
  __builtin_memcpy(&place, at, sizeof place);
  return place;
}

inline bool in_one_leaf(const BundlePlace& a, const BundlePlace& b) noexcept {
  using Halves = std::uint64_t __attribute__((vector_size(16)));
  const auto differ = reinterpret_cast<Halves>((a ^ b) >> plane_row::leaf_bits);
  return (differ[0] | differ[1]) == 0;
}

/// Sums over bundles in one leaf, eight of them in one vector.
struct BundleSums {
  using Eight = std::int32_t __attribute__((vector_size(32)));
  static constexpr std::int32_t middle = plane_row::leaf_side / 2;
  static constexpr std::int32_t one = middle + 1;  ///< 1 from the middle

  Eight sum = {};
  BundlePlace places = {};  ///< of x, y, z and 1 for each reading
  std::int64_t residual = 0;

  std::int32_t readings() const noexcept { return places[3]; }

  /// Adds readings that stand together.
  void add(const BundlePlace& at, std::int32_t more, std::int64_t squares) noexcept {
    using R = detail::PlaneRun;
    static_assert(R::xx == 0 && R::xy == 1 && R::zz == 2 && R::x == 3 && R::yy == 4 && R::yz == 5 &&
                  R::xz == 6 && R::y == 7);
    // x, y, z from the leaf's centre, and 1.
    const BundlePlace place = (at & (plane_row::leaf_side - 1)) - middle;
    sum += more * __builtin_shufflevector(place, place, 0, 0, 2, 0, 1, 1, 0, 1) *
           __builtin_shufflevector(place, place, 0, 1, 2, 3, 1, 2, 2, 3);
    places += more * place;
    residual += squares;
  }

  void add_to(detail::PlaneRun& run) const noexcept {
    Eight all;
    __builtin_memcpy(&all, run.sum, sizeof all);
    all += sum;
    __builtin_memcpy(run.sum, &all, sizeof all);
    run.z += places[2];
    run.residual += residual;
    run.readings += readings();
  }
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
