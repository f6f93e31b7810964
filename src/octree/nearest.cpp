// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/near_groups.hpp"
#include "octree/near_points.hpp"
#include "octree/node_distance.hpp"
#include "straightedge/octree.hpp"

namespace straightedge {
namespace {

/// Nodes that wait to be looked at. Each level leaves at most seven of eight children behind.
struct Waiting {
  struct Entry {
    double squared;
    std::uint32_t node;
  };
  Entry entries[7 * morton_levels + 2];  ///< and one that is written and not kept
  std::uint32_t size = 0;

  /// Children of a node that are not farther than `limit`, near ones on top: the one on the position's side
  /// of all three axes first, the opposite one last. No sorting: what it would save costs more.
  void push_children(const OctreeNodes& nodes, std::uint32_t parent, const octree::NodeDistance& distance,
                     double limit) noexcept {
    const octree::NodeDistance::Octants octants = distance.octants(nodes[parent]);
    const std::uint32_t near = octants.nearest();
    const auto above_octant = static_cast<unsigned>(3 * (nodes[parent].level() - 1));
    constexpr std::uint8_t rank[] = {7, 6, 5, 3, 4, 2, 1, 0};
    constexpr std::uint8_t flipped_at[] = {7, 6, 5, 3, 4, 2, 1, 0};
    std::uint32_t child_at[8];
    std::uint32_t present = 0;
    for (std::uint32_t child = parent + 1; child < nodes[parent].next; child = nodes[child].next) {
      const std::uint64_t key = nodes[child].key;
      const bool one_below = key >> 3U == nodes[parent].key;
      const auto octant =
          static_cast<std::uint32_t>(one_below ? key : nodes[child].code() >> above_octant) & 7U;
      const std::uint32_t at = rank[octant ^ near];
      child_at[at] = child;
      present |= 1U << at;
    }
    for (; present != 0; present &= present - 1) {
      const auto at = static_cast<std::uint32_t>(std::countr_zero(present));
      const double squared = octants.squared(near ^ flipped_at[at]);
      entries[size] = {squared, child_at[at]};
      size += squared <= limit ? 1U : 0U;
    }
  }
};

/// Calls look(leaf) for leaves, near ones first, as long as they are not farther than the limit that it
/// returns. Equal to the limit is not farther: such a leaf may hold a point of lower index.
template <class Look>
void for_near_leaves(const OctreeNodes& nodes, const octree::NodeDistance& distance, double limit,
                     Look look) noexcept {
  if (nodes.size() == 0) return;
  Waiting waiting;
  waiting.entries[waiting.size++] = {distance.squared(nodes[0]), 0};
  while (waiting.size > 0) {
    const Waiting::Entry entry = waiting.entries[--waiting.size];
    if (entry.squared > limit) continue;
    if (nodes.is_leaf(entry.node)) {
      limit = look(nodes[entry.node].first, nodes[entry.node + 1].first);
    } else {
      waiting.push_children(nodes, entry.node, distance, limit);
    }
  }
}

/// Around the position first; only when what is found there might not be the nearest, down the tree:
/// restart() forgets what was found and returns the limit.
template <class Look, class Restart>
void for_near_leaves(const detail::OctreeLeafGroups& groups, const OctreeNodes& nodes,
                     const octree::NodeDistance& distance, double limit, Look look,
                     Restart restart) noexcept {
  octree::GroupsAround around;
  if (groups.groups > 0 && around.find(distance.in_cells())) {
    limit = octree::look_around(groups, around, distance, limit, look);
    if (limit < distance.squared(octree::GroupsAround::reach)) return;
    limit = restart();
  }
  for_near_leaves(nodes, distance, limit, look);
}

/// The k nearest so far as a heap: the farthest of them is the first.
class Nearest {
 public:
  explicit Nearest(std::span<OctreeNeighbour> out) noexcept : heap_(out) {}

  bool full() const noexcept { return size_ == heap_.size(); }
  const OctreeNeighbour& farthest() const noexcept { return heap_[0]; }
  std::size_t size() const noexcept { return size_; }

  void offer(const OctreeNeighbour& neighbour) noexcept {
    if (!full()) {
      std::size_t at = size_++;
      for (; at > 0 && heap_[(at - 1) / 2].before(neighbour); at = (at - 1) / 2)
        heap_[at] = heap_[(at - 1) / 2];
      heap_[at] = neighbour;
    } else if (neighbour.before(heap_[0])) {
      sift_down(neighbour, size_);
    }
  }
  /// Nearest first; nothing can be offered any more.
  void sort() noexcept {
    for (std::size_t end = size_; end > 1; --end) {
      const OctreeNeighbour last = heap_[end - 1];
      heap_[end - 1] = heap_[0];
      sift_down(last, end - 1);
    }
  }

 private:
  /// Puts a neighbour in the place of the first of `size`.
  void sift_down(const OctreeNeighbour& neighbour, std::size_t size) noexcept {
    std::size_t at = 0;
    for (std::size_t child = 1; child < size; child = 2 * at + 1) {
      if (child + 1 < size && heap_[child].before(heap_[child + 1])) ++child;
      if (!neighbour.before(heap_[child])) break;
      heap_[at] = heap_[child];
      at = child;
    }
    heap_[at] = neighbour;
  }

  std::span<OctreeNeighbour> heap_;
  std::size_t size_ = 0;
};

Status check_query(bool prepared, const Vector3& position, double max_distance_m) noexcept {
  if (!prepared) return Status::not_prepared;
  return octree::is_position(position) && max_distance_m >= 0 ? Status::ok : Status::invalid_option;
}

}  // namespace

OctreeFound Octree::nearest(const Vector3& position, OctreeNeighbour& out,
                            double max_distance_m) const noexcept {
  OctreeFound found{check_query(prepared_, position, max_distance_m), 0, 0};
  if (found.status != Status::ok) return found;
  OctreeNeighbour best{UINT32_MAX, max_distance_m * max_distance_m};
  const octree::NodeDistance distance(options_.grid, position);
  octree::FarFilter filter(position);
  filter.set_limit(best.squared_distance);
  for_near_leaves(
      groups_, nodes_, distance, best.squared_distance,
      [&](std::uint32_t place, std::uint32_t end) {
        octree::find_nearest(*options_.kernels, memory_.points, place, end, position, filter, best);
        return best.squared_distance;
      },
      [&] { return best.squared_distance; });
  if (best.index == UINT32_MAX) return found;
  out = best;
  found.found = found.written = 1;
  return found;
}

OctreeFound Octree::k_nearest(const Vector3& position, std::span<OctreeNeighbour> out,
                              double max_distance_m) const noexcept {
  OctreeFound found{check_query(prepared_, position, max_distance_m), 0, 0};
  if (found.status != Status::ok || out.empty()) return found;
  double limit = max_distance_m * max_distance_m;
  Nearest nearest(out);
  const octree::NodeDistance distance(options_.grid, position);
  for_near_leaves(
      groups_, nodes_, distance, limit,
      [&](std::uint32_t place, std::uint32_t end) {
        octree::for_near_points(memory_.points, place, end, position, limit,
                                [&](const OctreeNeighbour& neighbour) {
                                  nearest.offer(neighbour);
                                  if (nearest.full()) limit = nearest.farthest().squared_distance;
                                });
        return limit;
      },
      [&] {
        nearest = Nearest(out);
        return limit = max_distance_m * max_distance_m;
      });
  nearest.sort();
  found.found = found.written = static_cast<std::uint32_t>(nearest.size());
  return found;
}

}  // namespace straightedge
