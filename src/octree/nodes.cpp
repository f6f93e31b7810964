// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/octree_nodes.hpp"

namespace straightedge {
namespace {

constexpr std::size_t most_codes = std::size_t{1} << 31U;

bool in_order(std::span<const std::uint64_t> codes) noexcept {
  if (codes.size() > most_codes) return false;
  for (std::size_t i = 1; i < codes.size(); ++i)
    if (codes[i - 1] > codes[i]) return false;
  return codes.empty() || codes.back() < morton_codes;
}

std::uint32_t count_leaves(std::span<const std::uint64_t> codes) noexcept {
  std::uint32_t leaves = codes.empty() ? 0 : 1;
  for (std::size_t i = 1; i < codes.size(); ++i) leaves += codes[i - 1] != codes[i];
  return leaves;
}

void list_leaves(std::span<const std::uint64_t> codes, std::span<OctreeNode> memory) noexcept {
  std::uint32_t leaves = 0;
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (i == 0 || codes[i - 1] != codes[i])
      memory[leaves++] = {OctreeNode::key_of(codes[i], 0), static_cast<std::uint32_t>(i), 0};
}

/// Inner nodes whose first leaf is not known yet: their levels, the lowest on top, and the place where what
/// follows them begins. Levels differ, so there are never more than 21.
class OpenBranches {
 public:
  /// A leaf parts at `level` from what begins at `place` to its right.
  void part(int level, std::uint32_t place) noexcept {
    const std::uint32_t end = size_ == 0 ? end_ : branches_[size_ - 1].latest_child;
    if (size_ == 0 || branches_[size_ - 1].level != level) branches_[size_++] = {level, end, place};
    branches_[size_ - 1].latest_child = place;
  }
  bool any_below(int level) const noexcept { return size_ > 0 && branches_[size_ - 1].level < level; }
  /// Takes the lowest; its subtree ends before `end`.
  void pop(int& level, std::uint32_t& end) noexcept {
    --size_;
    level = branches_[size_].level;
    end = branches_[size_].end;
  }
  explicit OpenBranches(std::uint32_t end) noexcept : end_(end) {}

 private:
  struct Branch {
    int level = 0;
    std::uint32_t end = 0;
    std::uint32_t latest_child = 0;
  };
  Branch branches_[morton_levels + 1];
  int size_ = 0;
  std::uint32_t end_;
};

/// Moves nodes from the end of the memory to its start.
void move_to_front(std::span<OctreeNode> memory, std::uint32_t from, std::uint32_t count) noexcept {
  for (std::uint32_t i = 0; i < count; ++i) {
    memory[i] = memory[from + i];
    memory[i].next -= from;
  }
}

/// What is told apart by a child's place in the cube of 3 x 3 x 3 round a leaf.
constexpr int distance_from_middle(int dx, int dy, int dz) noexcept {
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace

Status OctreeNodes::build(OctreeNodes& nodes, std::span<const std::uint64_t> sorted_codes,
                          std::span<OctreeNode> memory) noexcept {
  if (!in_order(sorted_codes)) return Status::invalid_image;

  // Step 1
  const std::uint32_t leaves = count_leaves(sorted_codes);
  if (leaves > most_codes / 2 || nodes_for(leaves) > memory.size()) return Status::workspace_too_small;
  list_leaves(sorted_codes, memory);

  // Steps 2 and 3
  nodes = link(memory, leaves, static_cast<std::uint32_t>(sorted_codes.size()));
  return Status::ok;
}

OctreeNodes OctreeNodes::link(std::span<OctreeNode> memory, std::uint32_t leaves,
                              std::uint32_t points) noexcept {
  OctreeNodes nodes;
  if (leaves == 0) return nodes;
  // Leaf i is still listed when its turn comes: those behind it have taken at most 2 (leaves - 1 - i) places
  // from the end, so that the lowest is above i.
  std::uint32_t place = 2 * leaves - 1;
  const OctreeNode end{0, points, 0};
  memory[place] = end;
  OpenBranches open(place);
  for (std::uint32_t i = leaves; i-- > 0;) {
    // Step 2
    const OctreeNode leaf = memory[i];
    const int parting = i == 0 ? morton_levels + 1 : morton_common_level(memory[i - 1].code(), leaf.code());

    // Step 3
    memory[--place] = {leaf.key, leaf.first, place + 1};
    while (open.any_below(parting)) {
      int level = 0;
      std::uint32_t subtree_end = 0;
      open.pop(level, subtree_end);
      memory[--place] = {OctreeNode::key_of(leaf.code(), level), leaf.first, subtree_end};
    }
    if (i > 0) open.part(parting, place);
  }
  nodes.size_ = 2 * leaves - 1 - place;
  nodes.leaves_ = leaves;
  move_to_front(memory, place, nodes.size_ + 1);
  nodes.nodes_ = memory.first(nodes.size_ + 1);
  return nodes;
}

std::uint32_t OctreeNodes::lower_bound(std::uint64_t code, int level) const noexcept {
  std::uint32_t low = 0, high = size_;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    const std::uint64_t here = nodes_[middle].code();
    if (here < code || (here == code && nodes_[middle].level() > level)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::uint32_t OctreeNodes::find(std::uint64_t code) const noexcept {
  const std::uint32_t i = lower_bound(code, 0);
  return i < size_ && nodes_[i].code() == code ? i : size_;
}

OctreeCell OctreeNodes::cell(std::uint64_t code, int level) const noexcept {
  const std::uint64_t begin = morton_ancestor(code, level);
  const std::uint32_t i = lower_bound(begin, level);
  if (i == size_ || morton_ancestor(nodes_[i].code(), level) != begin) return {begin, level, 0, 0};
  return seen_at(i, level);
}

std::size_t OctreeNodes::neighbours(std::uint64_t code, OctreeAdjacency adjacency,
                                    std::span<std::uint32_t> out) const noexcept {
  std::size_t found = 0;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int distance = distance_from_middle(dx, dy, dz);
        if (distance == 0 || distance > static_cast<int>(adjacency)) continue;
        const MortonNeighbour there = morton_neighbour(code, 0, dx, dy, dz);
        const std::uint32_t leaf = there.inside ? find(there.code) : size_;
        if (leaf == size_) continue;
        if (found < out.size()) out[found] = leaf;
        ++found;
      }
    }
  }
  return found;
}

}  // namespace straightedge
