// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "straightedge/morton.hpp"

/// What the array of a linear octree is made of (octree_nodes.hpp).
namespace straightedge {

struct OctreeNode {
  std::uint64_t key = 0;  ///< the digit 1, then three bits for each level from the root down to the node
  std::uint32_t first =
      0;  ///< place of its first point (or code) in sorted order; it ends where `next` begins
  std::uint32_t next = 0;  ///< the node after its last descendant; for a leaf the node after it

  constexpr int level() const noexcept { return std::countl_zero(key) / 3; }  ///< 0 = leaf to 21 = root
  /// The first leaf code that can lie in it.
  constexpr std::uint64_t code() const noexcept {
    return (key << static_cast<unsigned>(std::countl_zero(key))) & (morton_codes - 1);
  }
  static constexpr std::uint64_t key_of(std::uint64_t code, int level) noexcept {
    return (code | morton_codes) >> static_cast<unsigned>(3 * level);
  }
};

/// What a node of any level holds, whether it is in the array or left out as the only child of its parent.
struct OctreeCell {
  std::uint64_t code = 0;   ///< the node's first
  int level = 0;            ///< 0 = leaf to 21 = everything
  std::uint32_t first = 0;  ///< place of its first point
  std::uint32_t count = 0;  ///< its points; 0 = there is no such node
};

}  // namespace straightedge
