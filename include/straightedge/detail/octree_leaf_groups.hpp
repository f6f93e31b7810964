// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/morton.hpp"
#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_nodes.hpp"

namespace straightedge::detail {

/// Leaves by groups of 4 x 4 x 4 cells, for queries that look near to where they ask: a hash table leads to a
/// group without coming down from the root, and of each of its leaves there is the box of the points, which
/// on a surface is much smaller than the leaf.
///
/// It lies in what is left of the memory of the nodes; when that does not do, or leaves hold so few points
/// that their boxes save little, there are no groups and queries go through the tree alone.
struct OctreeLeafGroups {
  static constexpr int level = 2;
  static constexpr std::uint32_t most_leaves = 64;  ///< of a group
  /// Boxes are counted in units of which a group has so many along a side.
  static constexpr std::uint32_t units = 256;
  static constexpr std::uint32_t units_a_cell = units >> static_cast<unsigned>(level);

  /// Where the search for a group begins; its terms add up, so that those of neighbours are at hand.
  static constexpr std::uint32_t by_x = 0x9e37'79b1, by_y = 0x85eb'ca77, by_z = 0xc2b2'ae3d;

  std::span<std::uint32_t> slots;  ///< a group's number and one; 0 = free; at least half of them are
  std::uint32_t shift = 0;         ///< from the sum of terms to a slot
  std::uint32_t groups = 0;        ///< 0: none were made

  /// Elements of a group; what belongs to its leaves begins at `first` and ends where the next group begins.
  std::span<std::uint32_t> first, code_low, code_high;
  /// Elements of a leaf: its first point, and the corners of its box: x, then y and z eight bits higher each.
  std::span<std::uint32_t> place, low, high;

  void build(const OctreeNodes& nodes, const OctreeGrid& grid, std::span<const std::uint32_t> points,
             std::span<std::uint32_t> memory) noexcept;

  /// `groups` when there is none. `code` is that of the group's first cell, `sum` by_x · x + by_y · y + by_z
  /// · z of the group's place among groups.
  std::uint32_t find(std::uint64_t code, std::uint32_t sum) const noexcept {
    const auto last = static_cast<std::uint32_t>(slots.size()) - 1;
    for (std::uint32_t slot = sum >> shift;; slot = (slot + 1) & last) {
      const std::uint32_t entry = slots[slot];
      if (entry == 0) return groups;
      if (code_low[entry - 1] == static_cast<std::uint32_t>(code) && code_high[entry - 1] == code >> 32U)
        return entry - 1;
    }
  }

 private:
  bool take(std::size_t count, std::size_t leaves, std::span<std::uint32_t> memory) noexcept;
  void add_group(const MortonCell& cell, std::uint32_t leaf) noexcept;
};

}  // namespace straightedge::detail
