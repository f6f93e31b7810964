// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/detail/octree_leaf_groups.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge::octree {

/// The eight groups that are nearest to a position: the one it lies in, and those beyond the nearest of its
/// borders along one, two or three axes. What is in none of them is farther than half a group.
class GroupsAround {
  using Groups = detail::OctreeLeafGroups;

 public:
  /// False: the position lies outside the octree's cube, or at its border.
  bool find(const Vector3& in_cells) noexcept {
    std::uint32_t low[3];
    if (!find(0, in_cells.x, low) || !find(1, in_cells.y, low) || !find(2, in_cells.z, low)) return false;
    low_ = Groups::address(low[0], low[1], low[2]);
    return true;
  }
  /// Groups are numbered from 0 to 7: bits 0, 1, 2 say upper along x, y, z.
  std::uint32_t home() const noexcept { return home_; }
  Groups::Address address(std::uint32_t group) const noexcept {
    return low_ + Groups::address(group & 1U, group >> 1U & 1U, group >> 2U);
  }
  /// The unit in which the position lies along an axis, counted from the group's first one: -128 to 384.
  std::int16_t unit(std::uint32_t group, std::uint32_t axis) const noexcept {
    const std::int32_t start = group >> axis & 1U ? static_cast<std::int32_t>(Groups::units) : 0;
    return static_cast<std::int16_t>(unit_[axis] - start);
  }
  /// How far the border is away, in cells and a little less.
  double gap(std::uint32_t axis) const noexcept { return gap_[axis]; }
  /// What is in none of the groups is farther, in cells.
  static constexpr double reach = 0.5 * (1 << Groups::level) - 0x1p-20;

 private:
  bool find(std::uint32_t axis, double at, std::uint32_t* low) noexcept {
    constexpr double side = 1 << Groups::level, most = morton_side / side - 1;
    const double nearest = at * (1 / side) + 0.5;
    if (!(nearest >= 1 && nearest < most)) return false;
    const auto border = static_cast<std::int32_t>(nearest);
    const double beyond = at - side * border;
    low[axis] = static_cast<std::uint32_t>(border) - 1;
    home_ |= beyond < 0 ? 0U : 1U << axis;
    unit_[axis] = static_cast<std::int32_t>((beyond + side) * Groups::units_a_cell);
    const double gap = __builtin_fabs(beyond) - 0x1p-27;
    gap_[axis] = gap > 0 ? gap : 0;
    return true;
  }

  double gap_[3] = {};
  std::int32_t unit_[3] = {};  ///< from the lower groups' first
  std::uint32_t home_ = 0;
  Groups::Address low_;
};

}  // namespace straightedge::octree
