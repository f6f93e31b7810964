// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_key.hpp"

#include <cstdlib>

#include "straightedge/morton.hpp"
#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

std::uint32_t face_cell(std::int32_t along, std::int32_t axis) {
  const std::int32_t cell = (9 * (along + axis)) / (2 * axis);
  return static_cast<std::uint32_t>(cell > 8 ? 8 : cell);
}

}  // namespace

Vector3 cube_centre(std::uint64_t leaf, int level) noexcept {
  const MortonCell p = morton_decode(leaf);
  const auto middle = [level](std::uint32_t i) {
    const std::int64_t cube = i >> level;
    const std::int64_t side = std::int64_t{1} << level;
    const std::int64_t half = std::int64_t{1} << (plane_grid::axis_bits - 1);
    return (static_cast<double>(cube * side - half) + static_cast<double>(side) / 2) * plane_grid::leaf_m;
  };
  return {middle(p.x), middle(p.y), middle(p.z)};
}

GridNormal grid_normal(const Vector3& unit) noexcept {
  const auto whole = [](double c) {
    return static_cast<std::int32_t>(round_half_even(c * (1 / plane_grid::normal_unit)));
  };
  return {whole(unit.x), whole(unit.y), whole(unit.z)};
}

std::uint32_t direction_bin(const GridNormal& n) noexcept {
  const std::int32_t ax = std::abs(n.x);
  const std::int32_t ay = std::abs(n.y);
  const std::int32_t az = std::abs(n.z);
  if (ax >= ay && ax >= az && ax > 0)
    return (n.x > 0 ? 0U : 81U) + 9 * face_cell(n.y, ax) + face_cell(n.z, ax);
  if (ay >= az && ay > 0) return (n.y > 0 ? 162U : 243U) + 9 * face_cell(n.x, ay) + face_cell(n.z, ay);
  if (az > 0) return (n.z > 0 ? 324U : 405U) + 9 * face_cell(n.x, az) + face_cell(n.y, az);
  return 0;
}

std::uint32_t surface_bin(std::uint32_t direction, double offset_quanta) noexcept {
  const double step = offset_quanta * (1 / offset_step) + offset_bins / 2;
  const double bounded = step < 0 ? 0 : (step > offset_bins - 1 ? offset_bins - 1 : step);
  return direction * offset_bins + static_cast<std::uint32_t>(bounded);
}

}  // namespace straightedge
