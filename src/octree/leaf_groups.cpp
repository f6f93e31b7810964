// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/detail/octree_leaf_groups.hpp"

#include <bit>
#include <cstring>
#include <limits>

#include "straightedge/octree_point.hpp"

namespace straightedge::detail {
namespace {

using Floats4 = float __attribute__((vector_size(16)));
using Words4 = std::uint32_t __attribute__((vector_size(16)));

constexpr Words4 lanes{0, 1, 2, 3};
constexpr std::size_t group_words = 3;
constexpr std::size_t block_words = OctreeLeafGroups::block_bytes / sizeof(std::uint32_t);
/// Of a leaf, on the average. With fewer, looking at the points takes no longer than at their box.
constexpr std::uint32_t least_points = 6;

std::uint32_t count_groups(const OctreeNodes& nodes) noexcept {
  std::uint32_t groups = 0;
  for (std::uint32_t i = 0; i < nodes.size();) {
    const bool above = nodes[i].level() > OctreeLeafGroups::level;
    groups += above ? 0U : 1U;
    i = above ? i + 1 : nodes[i].next;
  }
  return groups;
}

/// The least and the greatest coordinates of points.
struct Extent {
  Floats4 low[3], high[3];

  Extent() noexcept {
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = Floats4{inf, inf, inf, inf};
      high[axis] = -low[axis];
    }
  }
  void add(const std::uint32_t* block, std::uint32_t begin, std::uint32_t end) noexcept {
    const auto mine = (lanes >= begin) & (lanes < end);
    for (int axis = 0; axis < 3; ++axis) {
      Floats4 here;
      std::memcpy(&here, block + 4 * axis, sizeof(here));
      const Floats4 below = mine ? here : low[axis], above = mine ? here : high[axis];
      low[axis] = below < low[axis] ? below : low[axis];
      high[axis] = above > high[axis] ? above : high[axis];
    }
  }
  void add_whole(const std::uint32_t* block) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
      Floats4 here;
      std::memcpy(&here, block + 4 * axis, sizeof(here));
      low[axis] = here < low[axis] ? here : low[axis];
      high[axis] = here > high[axis] ? here : high[axis];
    }
  }
  static double least(const Floats4& v) noexcept {
    const float a = v[0] < v[1] ? v[0] : v[1], b = v[2] < v[3] ? v[2] : v[3];
    return static_cast<double>(a < b ? a : b);
  }
  Vector3 min() const noexcept { return {least(low[0]), least(low[1]), least(low[2])}; }
  Vector3 max() const noexcept { return {-least(-high[0]), -least(-high[1]), -least(-high[2])}; }
};

Extent extent_of(std::span<const std::uint32_t> points, std::uint32_t first, std::uint32_t end) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  Extent extent;
  std::uint32_t begin = first - first % in_block;
  const std::uint32_t* block = points.data() + octree_point_words * begin;
  for (; begin < end; begin += in_block, block += octree_point_words * in_block) {
    if (begin >= first && begin + in_block <= end) {
      extent.add_whole(block);
    } else {
      extent.add(block, begin < first ? first - begin : 0, end - begin);
    }
  }
  return extent;
}

/// The unit in which a coordinate lies, from the group's first cell on.
unsigned char unit_of(double at, std::uint32_t cell) noexcept {
  const double unit =
      (at - static_cast<double>(static_cast<std::int32_t>(cell))) * OctreeLeafGroups::units_a_cell;
  const auto whole = static_cast<std::int32_t>(unit);
  constexpr auto last = static_cast<std::int32_t>(OctreeLeafGroups::units - 1);
  return static_cast<unsigned char>(whole < 0 ? 0 : whole > last ? last : whole);
}

}  // namespace

bool OctreeLeafGroups::take(std::size_t count, std::size_t leaves, std::span<std::uint32_t> memory) noexcept {
  const std::size_t table = std::bit_ceil(4 * count);
  const std::size_t group_elements = count + 1, blocks = (leaves + in_block - 1) / in_block;
  if (table + group_words * group_elements + leaves + 1 + block_words * blocks > memory.size()) return false;
  const auto next = [&memory](std::size_t words) {
    const std::span<std::uint32_t> taken = memory.first(words);
    memory = memory.subspan(words);
    return taken;
  };
  slots = next(table);
  shift = static_cast<std::uint32_t>(32 - std::countr_zero(table));
  first = next(group_elements);
  key_low = next(group_elements);
  key_high = next(group_elements);
  place = next(leaves + 1);
  boxes = {reinterpret_cast<unsigned char*>(next(block_words * blocks).data()), block_bytes * blocks};
  for (std::uint32_t& slot : slots) slot = 0;
  return true;
}

void OctreeLeafGroups::add_group(const Address& address, std::uint32_t leaf) noexcept {
  std::uint32_t slot = address.sum >> shift;
  while (slots[slot] != 0) slot = (slot + 1) & (static_cast<std::uint32_t>(slots.size()) - 1);
  first[groups] = leaf;
  key_low[groups] = address.key_low();
  key_high[groups] = address.key_high();
  slots[slot] = ++groups;
}

void OctreeLeafGroups::build(const OctreeNodes& nodes, const OctreeGrid& grid,
                             std::span<const std::uint32_t> points,
                             std::span<std::uint32_t> memory) noexcept {
  *this = OctreeLeafGroups();
  const std::uint32_t leaves = nodes.leaves();
  if (leaves == 0 || nodes.points() / leaves < least_points) return;
  if (!take(count_groups(nodes), leaves, memory)) return;
  constexpr auto down = static_cast<unsigned>(level);
  std::uint32_t leaf = 0;
  for (std::uint32_t i = 0; i < nodes.size();) {
    if (nodes[i].level() > level) {
      ++i;
      continue;
    }
    const MortonCell cell = morton_decode(morton_ancestor(nodes[i].code(), level));
    add_group(address(cell.x >> down, cell.y >> down, cell.z >> down), leaf);
    for (const std::uint32_t end = nodes[i].next; i < end; ++i) {
      if (!nodes.is_leaf(i)) continue;
      const Extent extent = extent_of(points, nodes[i].first, nodes[i + 1].first);
      const Vector3 from = grid.in_cells(extent.min()), to = grid.in_cells(extent.max());
      place[leaf] = nodes[i].first;
      low(leaf, 0) = unit_of(from.x, cell.x);
      low(leaf, 1) = unit_of(from.y, cell.y);
      low(leaf, 2) = unit_of(from.z, cell.z);
      high(leaf, 0) = unit_of(to.x, cell.x);
      high(leaf, 1) = unit_of(to.y, cell.y);
      high(leaf, 2) = unit_of(to.z, cell.z);
      ++leaf;
    }
  }
  first[groups] = leaf;
  place[leaf] = nodes.points();
}

}  // namespace straightedge::detail
