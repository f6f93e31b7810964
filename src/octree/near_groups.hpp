// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "octree/near_points.hpp"
#include "octree/node_distance.hpp"
#include "straightedge/detail/octree_leaf_groups.hpp"
#include "straightedge/morton.hpp"

namespace straightedge::octree {

using Words4 = std::uint32_t __attribute__((vector_size(16)));
using Integers4 = std::int32_t __attribute__((vector_size(16)));

constexpr Integers4 lanes4{0, 1, 2, 3};

/// How near to a position the boxes of a group's leaves are, squared, in units of boxes.
///
/// Floats err by less than 2^-14 of a unit here, and the boxes by less than 2^-20; every gap is made 2^-10
/// smaller. The limit is raised by more than squares and sums err.
class GroupDistance {
 public:
  /// The position in cells, at most two groups from a group's first cell.
  GroupDistance(const Vector3& at, const MortonCell& cell) noexcept
      : x_(from_corner(at.x, cell.x)), y_(from_corner(at.y, cell.y)), z_(from_corner(at.z, cell.z)) {}

  /// A little more than there are, for limit_of.
  static double square_units_a_m(double leaf_m) noexcept {
    const double units_a_m = detail::OctreeLeafGroups::units_a_cell / leaf_m;
    return units_a_m * units_a_m * (1 + 0x1p-12);
  }
  static float limit_of(double squared_m, double square_units_a_m) noexcept {
    const double limit = squared_m * square_units_a_m;
    return limit < 0x1p120 ? static_cast<float>(limit) : std::numeric_limits<float>::infinity();
  }
  /// Of four leaves; the six lowest bits are the number of the leaf instead, from `first` on.
  Integers4 squared(const std::uint32_t* low, const std::uint32_t* high, std::int32_t first) const noexcept {
    Words4 from, to;
    std::memcpy(&from, low, sizeof(from));
    std::memcpy(&to, high, sizeof(to));
    const Floats4 x = gap(from & 255U, to & 255U, x_);
    const Floats4 y = gap(from >> 8U & 255U, to >> 8U & 255U, y_);
    const Floats4 z = gap(from >> 16U, to >> 16U, z_);
    const Floats4 sum = x * x + y * y + z * z;
    Integers4 bits;
    std::memcpy(&bits, &sum, sizeof(bits));
    return (bits & ~63) | (lanes4 + first);
  }

 private:
  static float from_corner(double at, std::uint32_t cell) noexcept {
    return static_cast<float>((at - static_cast<double>(static_cast<std::int32_t>(cell))) *
                              detail::OctreeLeafGroups::units_a_cell);
  }
  static Floats4 gap(const Words4& from, const Words4& to, float at) noexcept {
    const Floats4 low = __builtin_convertvector(reinterpret_cast<const Integers4&>(from), Floats4) - at;
    const Floats4 high = at - __builtin_convertvector(reinterpret_cast<const Integers4&>(to), Floats4);
    const Floats4 beyond = (low > high - 1.0F ? low : high - 1.0F) - 0x1p-10F;
    return beyond > 0.0F ? beyond : beyond - beyond;
  }

  float x_, y_, z_;
};

/// Calls look(first, end) for the points of a group's leaves, the nearest leaf first, that are not farther
/// than the limit that it returns. Says the limit.
template <class Look>
double look_through_group(const detail::OctreeLeafGroups& groups, std::uint32_t group,
                          const GroupDistance& distance, double square_units_a_m, double limit,
                          Look look) noexcept {
  const std::uint32_t first = groups.first[group], count = groups.first[group + 1] - first;
  std::int32_t squares[detail::OctreeLeafGroups::most_leaves];
  Integers4 least{INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX};
  for (std::uint32_t i = 0; i < count; i += 4) {
    Integers4 here =
        distance.squared(&groups.low[first + i], &groups.high[first + i], static_cast<std::int32_t>(i));
    if (count - i < 4) here = lanes4 < static_cast<std::int32_t>(count - i) ? here : here | INT32_MAX;
    std::memcpy(squares + i, &here, sizeof(here));
    least = here < least ? here : least;
  }
  const std::int32_t a = least[0] < least[1] ? least[0] : least[1];
  const std::int32_t b = least[2] < least[3] ? least[2] : least[3];
  const std::int32_t nearest = a < b ? a : b;
  std::int32_t farthest = std::bit_cast<std::int32_t>(GroupDistance::limit_of(limit, square_units_a_m)) | 63;
  if (nearest > farthest) return limit;
  const auto look_at = [&](std::int32_t square) {
    const std::uint32_t leaf = first + (static_cast<std::uint32_t>(square) & 63U);
    limit = look(groups.place[leaf], groups.place[leaf + 1]);
    farthest = std::bit_cast<std::int32_t>(GroupDistance::limit_of(limit, square_units_a_m)) | 63;
  };
  look_at(nearest);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (squares[i] <= farthest && squares[i] != nearest) look_at(squares[i]);
  }
  return limit;
}

/// The same for the eight groups that are nearest to the position, whose cube begins at `cell`.
template <class Look>
double look_around(const detail::OctreeLeafGroups& groups, const MortonCell& cell,
                   const NodeDistance& distance, double square_units_a_m, double limit, Look look) noexcept {
  using Groups = detail::OctreeLeafGroups;
  constexpr auto shift = static_cast<unsigned>(Groups::level);
  constexpr std::uint32_t side = std::uint32_t{1} << shift;
  const NodeDistance::Octants octants = distance.octants(cell, Groups::level);
  const std::uint32_t near = octants.nearest();
  const std::uint32_t sum =
      Groups::by_x * (cell.x >> shift) + Groups::by_y * (cell.y >> shift) + Groups::by_z * (cell.z >> shift);
  for (const std::uint32_t away : {0U, 1U, 2U, 4U, 3U, 5U, 6U, 7U}) {
    const std::uint32_t octant = near ^ away;
    if (octants.squared(octant) > limit) continue;
    const std::uint32_t i = octant & 1U, j = octant >> 1U & 1U, k = octant >> 2U;
    const MortonCell there{cell.x + side * i, cell.y + side * j, cell.z + side * k};
    const std::uint32_t group =
        groups.find(morton_encode(there), sum + Groups::by_x * i + Groups::by_y * j + Groups::by_z * k);
    if (group == groups.groups) continue;
    limit = look_through_group(groups, group, GroupDistance(distance.in_cells(), there), square_units_a_m,
                               limit, look);
  }
  return limit;
}

}  // namespace straightedge::octree
