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

  /// Where a group lies among groups: what tells it from others, and where the search for it begins. Both add
  /// up, so that those of neighbours are at hand.
  struct Address {
    std::uint64_t key = 0;
    std::uint32_t sum = 0;

    constexpr Address operator+(const Address& other) const noexcept {
      return {key + other.key, sum + other.sum};
    }
    constexpr std::uint32_t key_low() const noexcept { return static_cast<std::uint32_t>(key); }
    constexpr std::uint32_t key_high() const noexcept { return static_cast<std::uint32_t>(key >> 32U); }
  };
  /// Of a group's coordinates, each below 2^19.
  static constexpr Address address(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept {
    return {x | std::uint64_t{y} << 19U | std::uint64_t{z} << 38U,
            0x9e37'79b1U * x + 0x85eb'ca77U * y + 0xc2b2'ae3dU * z};
  }

  std::span<std::uint32_t> slots;  ///< a group's number and one; 0 = free; at least half of them are
  std::uint32_t shift = 0;         ///< from the sum of an address to a slot
  std::uint32_t groups = 0;        ///< 0: none were made

  /// Elements of a group; what belongs to its leaves begins at `first` and ends where the next group begins.
  std::span<std::uint32_t> first, key_low, key_high;
  /// Of each leaf its first point.
  std::span<std::uint32_t> place;

  /// Boxes of leaves, in blocks of eight, so that several are looked at at once: eight lowest x, eight y,
  /// eight z, then the highest ones.
  static constexpr std::uint32_t in_block = 8;
  static constexpr std::uint32_t block_bytes = 6 * in_block;
  std::span<unsigned char> boxes;
  unsigned char& low(std::uint32_t leaf, std::uint32_t axis) const noexcept {
    return boxes[leaf / in_block * block_bytes + axis * in_block + leaf % in_block];
  }
  unsigned char& high(std::uint32_t leaf, std::uint32_t axis) const noexcept { return low(leaf, axis + 3); }

  void build(const OctreeNodes& nodes, const OctreeGrid& grid, std::span<const std::uint32_t> points,
             std::span<std::uint32_t> memory) noexcept;

  /// `groups` when there is none.
  std::uint32_t find(const Address& address) const noexcept {
    const auto last = static_cast<std::uint32_t>(slots.size()) - 1;
    for (std::uint32_t slot = address.sum >> shift;; slot = (slot + 1) & last) {
      const std::uint32_t entry = slots[slot];
      if (entry == 0) return groups;
      if (key_low[entry - 1] == address.key_low() && key_high[entry - 1] == address.key_high())
        return entry - 1;
    }
  }

 private:
  bool take(std::size_t count, std::size_t leaves, std::span<std::uint32_t> memory) noexcept;
  void add_group(const Address& address, std::uint32_t leaf) noexcept;
};

}  // namespace straightedge::detail
