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
  static constexpr std::size_t capacity = detail::CloudBlock::capacity;
  /// Beyond so many floats from one point to the next kernels of registers cannot reach sixteen at once.
  static constexpr std::ptrdiff_t most_step = std::ptrdiff_t{1} << 24;

  const Readings& readings;
  const Labels& labels;
  RansacPoints block;
  const float* first[3];
  std::ptrdiff_t step;

  CloudBlocks(const Readings& of, const Labels& with, const LinearPlane& plane, const AxisOrder& order,
              double gates) noexcept
      : readings(of), labels(with), first{of.points.x, of.points.y, of.points.z} {
    const double k[3] = {plane.x, plane.y, plane.z};
    const double origin[3] = {of.origin.x, of.origin.y, of.origin.z};
    const float* const from[3] = {first[0], first[1], first[2]};
    const int axis[3] = {order.x, order.y, order.z};
    for (int i = 0; i < 3; ++i) first[i] = from[axis[i]];
    step = of.points.stride / static_cast<std::ptrdiff_t>(sizeof(float));
    block.step = of.block == nullptr ? step : 1;
    block.origin_x = static_cast<float>(origin[order.x]);
    block.origin_y = static_cast<float>(origin[order.y]);
    block.origin_z = static_cast<float>(origin[order.z]);
    block.plane = {static_cast<float>(k[order.x]), static_cast<float>(k[order.y]),
                   static_cast<float>(k[order.z]), static_cast<float>(plane.w)};
    block.gate = static_cast<float>(gates * of.gate.fixed_m);
  }

  const RansacKernels& kernels(const RansacKernels& wished) const noexcept {
    return block.step > most_step ? plain_ransac_kernels : wished;
  }

  /// Calls visit(block) for every `part`-th block of readings: where they are, or gathered, so that what lies
  /// between them changes no sum.
  template <class Visit>
  void for_each(std::size_t part, Visit visit) noexcept {
    const std::size_t count = readings.points.count;
    std::size_t next = 0;
    for (std::size_t number = 0; next < count; ++number) {
      const std::size_t begin = next;
      if (readings.block == nullptr) {
        next = count - begin < capacity ? count : begin + capacity;
        if (number % part == 0) visit(in_place(begin, next));
      } else {
        next = gather(begin);
        if (number % part == 0 && block.count > 0) visit(block);
      }
    }
  }

 private:
  const RansacPoints& in_place(std::size_t begin, std::size_t end) noexcept {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(begin) * block.step;
    block.x = first[0] + at;
    block.y = first[1] + at;
    block.z = first[2] + at;
    block.count = static_cast<std::int32_t>(end - begin);
    block.labels = labels.kept() ? labels.data + begin : nullptr;
    return block;
  }

  /// Fills readings.block. Returns where the next one begins.
  std::size_t gather(std::size_t i) noexcept {
    detail::CloudBlock& to = *readings.block;
    std::size_t k = 0;
    for (; i < readings.points.count && k < capacity; ++i) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) * step;
      const float x = first[0][at], y = first[1][at], z = first[2][at];
      if (!(((x - x) + (y - y)) + (z - z) == 0)) continue;
      to.x[k] = x;
      to.y[k] = y;
      to.z[k] = z;
      to.number[k] = static_cast<std::uint32_t>(i);
      to.label[k++] = labels.kept() ? labels.data[i] : std::uint16_t{0};
    }
    block.x = to.x;
    block.y = to.y;
    block.z = to.z;
    block.count = static_cast<std::int32_t>(k);
    block.labels = labels.kept() ? to.label : nullptr;
    return i;
  }
};

}  // namespace straightedge::ransac
