// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/morton.hpp"
#include "straightedge/status.hpp"

/// The nodes of a linear octree: one array, no pointers, built from sorted Morton codes.
///
///   1. List the leaves: equal codes are one leaf, which knows where its codes begin.
///   2. Two neighbouring leaves part at the lowest level at which one node holds both. There, and only there,
///   is
///      an inner node: a chain of nodes with one child each is left out, so that n leaves have at most
///      n - 1 inner nodes, however far apart they lie.
///   3. Go through the leaves from the last to the first and write nodes from the end of the array to its
///      start, so that each node stands before its descendants. A stack of the levels at which a branch is
///      still open says which inner nodes begin with the leaf at hand; it holds at most one entry a level.
///
/// Each node says where its descendants end (`next`), so the whole tree is walked by two moves: to i + 1
/// (into the node) or to nodes[i].next (past it). No stack and no recursion are needed for that.
///
/// I. Gargantini, "An Effective Way to Represent Quadtrees", CACM 25(12), 1982, doi:10.1145/358728.358741.
/// T. Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees", HPG 2012,
/// doi:10.2312/EGGH/HPG12/033-037 (step 2: leaves part where their codes do).
///
/// Time: codes plus leaves. Memory: 32 bytes a leaf, the caller's.
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

/// Which neighbours of a leaf: those that share a face (6), at least an edge (18), at least a corner (26).
enum class OctreeAdjacency : std::uint8_t { faces = 1, edges = 2, corners = 3 };

class OctreeLevel;

/// A view of finished nodes; the memory is the caller's. The default is a tree without nodes.
class OctreeNodes {
 public:
  /// Elements of memory that a tree of so many leaves is built in; one of them stands behind the last node.
  static constexpr std::size_t nodes_for(std::size_t leaves) noexcept { return leaves == 0 ? 1 : 2 * leaves; }

  /// Builds the tree over codes in ascending order (equal ones allowed): code i is point i. `invalid_image`:
  /// they are not in order, one is 2^63 or more, or there are more than 2^31; `workspace_too_small`: the
  /// codes have more leaves than the memory is for. Both leave `nodes` as it was.
  static Status build(OctreeNodes& nodes, std::span<const std::uint64_t> sorted_codes,
                      std::span<OctreeNode> memory) noexcept;

  /// Steps 2 and 3 on leaves that are listed already: memory[i].key and .first for i below `leaves`, with
  /// memory for `nodes_for(leaves)`.
  static OctreeNodes link(std::span<OctreeNode> memory, std::uint32_t leaves, std::uint32_t points) noexcept;

  std::uint32_t size() const noexcept { return size_; }  ///< nodes; the root is node 0
  std::uint32_t leaves() const noexcept { return leaves_; }
  std::uint32_t points() const noexcept { return size_ == 0 ? 0 : nodes_[size_].first; }
  const OctreeNode& operator[](std::uint32_t i) const noexcept { return nodes_[i]; }
  std::uint32_t count_of(std::uint32_t i) const noexcept {
    return nodes_[nodes_[i].next].first - nodes_[i].first;
  }
  bool is_leaf(std::uint32_t i) const noexcept { return nodes_[i].next == i + 1; }

  /// The leaf with this code; size() when there is none. Time: log2 of the nodes.
  std::uint32_t find(std::uint64_t code) const noexcept;

  /// The node at `level` (0 to 21) that would hold this code, in the array or not. Time: log2 of the nodes.
  OctreeCell cell(std::uint64_t code, int level) const noexcept;

  /// Leaves beside the leaf position `code` (which need not be one itself), in the order of z, y, x offsets.
  /// Returns how many; what does not fit in `out` is left out. 26 always do.
  std::size_t neighbours(std::uint64_t code, OctreeAdjacency adjacency,
                         std::span<std::uint32_t> out) const noexcept;

  /// All nodes of one level in Morton order: `for (const OctreeCell& cell : nodes.level(3))`.
  OctreeLevel level(int level) const noexcept;

  /// Node i, seen at a level: its own, or a higher one below its parent's.
  OctreeCell seen_at(std::uint32_t i, int level) const noexcept {
    return {morton_ancestor(nodes_[i].code(), level), level, nodes_[i].first, count_of(i)};
  }

 private:
  std::uint32_t lower_bound(std::uint64_t code, int level) const noexcept;

  std::span<const OctreeNode> nodes_;  ///< one more than size_, when there are any
  std::uint32_t size_ = 0;
  std::uint32_t leaves_ = 0;
};

/// What a range-for runs over. Time: the nodes at or above the level.
class OctreeLevel {
 public:
  struct End {};
  class Iterator {
   public:
    Iterator(const OctreeNodes& nodes, int level) noexcept : nodes_(&nodes), level_(level) { descend(); }
    OctreeCell operator*() const noexcept { return nodes_->seen_at(at_, level_); }
    Iterator& operator++() noexcept {
      at_ = (*nodes_)[at_].next;
      descend();
      return *this;
    }
    bool operator==(End) const noexcept { return at_ == nodes_->size(); }

   private:
    void descend() noexcept {
      while (at_ < nodes_->size() && (*nodes_)[at_].level() > level_) ++at_;
    }
    const OctreeNodes* nodes_;
    int level_;
    std::uint32_t at_ = 0;
  };

  OctreeLevel(const OctreeNodes& nodes, int level) noexcept : nodes_(nodes), level_(level) {}
  Iterator begin() const noexcept { return {nodes_, level_}; }
  End end() const noexcept { return {}; }

 private:
  OctreeNodes nodes_;
  int level_;
};

inline OctreeLevel OctreeNodes::level(int level) const noexcept {
  return {*this, level};
}

}  // namespace straightedge
