// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/host/plane_leaves.hpp"
#include "straightedge/morton.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge {

/// A unit normal in plane_grid::normal_unit.
struct GridNormal {
  std::int32_t x = 0, y = 0, z = 0;
};

/// Half the grid, in quanta: what makes grid coordinates of world coordinates positive.
inline constexpr double grid_middle =
    static_cast<double>(std::int64_t{1} << (plane_grid::axis_bits + plane_grid::leaf_bits - 1));
inline constexpr double grid_end = 2 * grid_middle;

/// The middle of a cube whose sides are 2^level leaves.
Vector3 cube_centre(std::uint64_t leaf, int level) noexcept;

/// The same of one leaf, by its place.
inline Vector3 leaf_centre(const MortonCell& leaf) noexcept {
  constexpr std::int32_t half = 1 << (plane_grid::axis_bits - 1);
  const auto middle = [](std::uint32_t i) {
    return (static_cast<std::int32_t>(i) - half + 0.5) * plane_grid::leaf_m;
  };
  return {middle(leaf.x), middle(leaf.y), middle(leaf.z)};
}

GridNormal grid_normal(const Vector3& unit) noexcept;

/// Cells on the faces of a cube, 9 by 9 each, ten degrees wide: an odd number, so that walls along the
/// axes fall into the middle of a cell and noise does not spread them over several.
std::uint32_t direction_bin(const GridNormal& normal) noexcept;

/// Surfaces of one direction are told apart by their offset from the leaf's centre, in steps of 1/64 m.
inline constexpr int offset_bins = 16;
inline constexpr double offset_step = 32;  ///< quanta
std::uint32_t surface_bin(std::uint32_t direction, double offset_quanta) noexcept;
inline constexpr std::uint32_t surface_bins = 6 * 81 * offset_bins;

}  // namespace straightedge
