// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/labels.hpp"
#include "ransac/readings.hpp"
#include "straightedge/ransac_kernels.hpp"

namespace straightedge::ransac {

/// The axes of a cloud in another order: the one along which the plane's normal is longest comes last.
struct AxisOrder {
  int x = 0, y = 1, z = 2;
};

inline double squared_along(double x) noexcept {
  return x * x;
}

inline AxisOrder axis_order(const LinearPlane& p) noexcept {
  const double x = squared_along(p.x), y = squared_along(p.y), z = squared_along(p.z);
  if (z >= x && z >= y) return {0, 1, 2};
  return y >= x ? AxisOrder{2, 0, 1} : AxisOrder{1, 2, 0};
}

/// Points of a cloud with a gate in metres, in the pieces that the kernels take.
struct CloudBlocks {
  static constexpr std::size_t capacity = 1024;
  /// Beyond so many floats from one point to the next kernels of registers cannot reach sixteen at once.
  static constexpr std::ptrdiff_t most_step = std::ptrdiff_t{1} << 24;

  const Readings& readings;
  const Labels& labels;
  RansacPoints block;
  const float* first[3];

  CloudBlocks(const Readings& of, const Labels& with, const LinearPlane& plane, const AxisOrder& order) noexcept
      : readings(of), labels(with), first{of.points.x, of.points.y, of.points.z} {
    const double k[3] = {plane.x, plane.y, plane.z};
    const double origin[3] = {of.origin.x, of.origin.y, of.origin.z};
    const float* const from[3] = {first[0], first[1], first[2]};
    const int axis[3] = {order.x, order.y, order.z};
    for (int i = 0; i < 3; ++i) first[i] = from[axis[i]];
    block.step = of.points.stride / static_cast<std::ptrdiff_t>(sizeof(float));
    block.origin_x = static_cast<float>(origin[order.x]);
    block.origin_y = static_cast<float>(origin[order.y]);
    block.origin_z = static_cast<float>(origin[order.z]);
    block.plane = {static_cast<float>(k[order.x]), static_cast<float>(k[order.y]),
                   static_cast<float>(k[order.z]), static_cast<float>(plane.w)};
    block.gate = static_cast<float>(of.gate.fixed_m);
  }

  const RansacKernels& kernels(const RansacKernels& wished) const noexcept {
    return block.step > most_step ? plain_ransac_kernels : wished;
  }

  /// Calls visit(block, number of its first point) for every `part`-th block.
  template <class Visit>
  void for_each(std::size_t part, Visit visit) noexcept {
    const std::size_t count = readings.points.count;
    for (std::size_t i = part / 2 * capacity < count ? part / 2 * capacity : 0; i < count; i += part * capacity) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * block.step;
      block.x = first[0] + at;
      block.y = first[1] + at;
      block.z = first[2] + at;
      block.count = static_cast<std::int32_t>(count - i < capacity ? count - i : capacity);
      block.labels = labels.kept() ? labels.data + i : nullptr;
      visit(block, i);
    }
  }
};

}  // namespace straightedge::ransac
