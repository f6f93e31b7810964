// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/detail/octree_leaf_groups.hpp"
#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/octree_nodes.hpp"
#include "straightedge/octree_point.hpp"
#include "straightedge/octree_ray.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/status.hpp"

/// A linear octree of points: nearest points, points in a ball or a box, leaves along a ray.
///
/// Building
///   1. Read: each point's cell and Morton code (octree_grid.hpp, morton.hpp). What is outside the cube or
///      not finite is counted and left out.
///   2. Sort by code: least significant digit first (radix sort), which keeps the order within a cell.
///      Digits in which all codes agree are passed over.
///   3. Copy the points in that order, with their indices, so that a leaf's points lie side by side.
///   4. Merge them with the points that are there already (insert alone).
///   5. List the leaves and link the nodes above them (octree_nodes.hpp).
///   6. In memory of nodes that is left: boxes of the leaves' points (detail/octree_leaf_groups.hpp).
///
/// Asking (rays: octree_ray.hpp)
///   nearest, k_nearest   Leaves around the position by step 6; if they do not settle it, down the tree into
///                        the nearest child first. What is farther than the best so far is passed over.
///   radius, box          Through the array of nodes; past those that do not touch the ball or box.
///
/// Exact: no query misses a point by rounding. Squared distances are (dx² + dy²) + dz² in doubles; of
/// points at the same distance the one with the lower index counts as nearer. Indices count the points
/// as they were given: build(a), insert(b) gives those of a followed by b, and equals building both at once.
///
/// Time: build linear in points (two to six passes); insert as much for the new, plus a pass over all there
/// are: many points a call, not one. Nearest about the height of the tree plus the points of a few
/// leaves. Memory: 16 bytes a point and 32 a leaf, all in the workspace; sorting takes place in the memory of
/// the result. Queries take at most 4 KB of stack, since a node leaves at most seven others behind a level.
namespace straightedge {

struct OctreeOptions {
  OctreeGrid grid = {};
  std::uint32_t max_leaves = 0;  ///< there is memory for; 0 = as many as points. A quarter to spare: step 6
  const OctreeKernels* kernels = &plain_octree_kernels;  ///< not null
};

/// What build and insert say; a status other than `ok` tells why nothing was added.
///   not_prepared
///   invalid_image        the view makes no sense; no points at all are fine
///   size_mismatch        more points in the cube than the capacity
///   workspace_too_small  more than max_leaves leaves; `leaves` says how many there would be
///   too_large            more than 2^32 - 1 points were given since build
struct OctreeBuildResult {
  Status status = Status::not_prepared;
  std::uint32_t points = 0;    ///< of this call that are in the octree
  std::uint32_t left_out = 0;  ///< of this call that are outside the cube or not finite
  std::uint32_t leaves = 0;    ///< of the octree
};

inline constexpr double octree_unlimited = std::numeric_limits<double>::infinity();

/// `prepare` once, `build` many times; the workspace is the caller's and must outlive the object. Queries
/// change nothing, so any number of them may run at a time. Each says `not_prepared`, or `invalid_option`
/// for a position not within 1e100 of 0, or a distance that is negative or no number.
class Octree {
 public:
  /// Bytes that `prepare` needs; 0 when capacity or options are invalid. Usable in constant expressions.
  static constexpr std::size_t workspace_bytes(std::uint32_t capacity,
                                               const OctreeOptions& options) noexcept {
    if (check(capacity, options) != Status::ok) return 0;
    Arena arena = Arena::measure();
    Memory::take(arena, capacity, options);
    return arena.used();
  }

  /// `invalid_option`, `too_large` (capacity not 1 to 2^30, or more than the machine can address),
  /// `workspace_too_small`; each leaves `octree` unprepared.
  static Status prepare(Octree& octree, std::uint32_t capacity, const OctreeOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// Replaces what is there; after an error the octree is empty.
  OctreeBuildResult build(const PointsView& points) noexcept;
  /// Adds to what is there; after an error the octree is as before.
  OctreeBuildResult insert(const PointsView& points) noexcept;
  void clear() noexcept;

  /// The nearest point, at most max_distance_m away; `found` 0 or 1.
  OctreeFound nearest(const Vector3& position, OctreeNeighbour& out,
                      double max_distance_m = octree_unlimited) const noexcept;
  /// The out.size() nearest points, nearest first. `ok` also when there are fewer.
  OctreeFound k_nearest(const Vector3& position, std::span<OctreeNeighbour> out,
                        double max_distance_m = octree_unlimited) const noexcept;
  /// All points at most radius_m away, in Morton order of leaves. `output_full`: more were found than
  /// fit; an empty `out` only counts.
  OctreeFound radius(const Vector3& position, double radius_m, std::span<OctreeNeighbour> out) const noexcept;
  /// Indices of all points in a closed box (min <= max, infinities allowed), in Morton order of leaves.
  OctreeFound box(const OctreeBox& box, std::span<std::uint32_t> out) const noexcept;
  /// All leaves that the ray crosses, in order.
  OctreeFound ray(const OctreeRay& ray, std::span<OctreeCrossing> out) const noexcept;
  /// The first of them; `found` 0 or 1.
  OctreeFound first_hit(const OctreeRay& ray, OctreeCrossing& out) const noexcept;

  const OctreeGrid& grid() const noexcept { return options_.grid; }
  /// The tree. Points of node i: nodes().count_of(i) places from nodes()[i].first on.
  const OctreeNodes& nodes() const noexcept { return nodes_; }
  std::uint32_t size() const noexcept { return size_; }
  /// Point at a place of the sorted order, below size().
  OctreePoint point(std::uint32_t place) const noexcept { return OctreePoint::read(memory_.points, place); }

  static constexpr Status check(std::uint32_t capacity, const OctreeOptions& options) noexcept {
    if (!options.grid.valid()) return Status::invalid_option;
    if (capacity == 0 || capacity > (std::uint32_t{1} << 30U)) return Status::too_large;
    return std::uint64_t{capacity} * 48 + (1U << 16U) > SIZE_MAX ? Status::too_large : Status::ok;
  }

 private:
  struct Memory {
    std::span<std::uint32_t> points;  ///< as OctreePoint writes them
    std::span<OctreeNode> nodes;
    std::span<std::uint32_t> counts;  ///< of a digit's values, while sorting

    static constexpr Memory take(Arena& arena, std::uint32_t capacity,
                                 const OctreeOptions& options) noexcept {
      const bool fewer = options.max_leaves > 0 && options.max_leaves < capacity;
      Memory memory;
      memory.points = arena.take<std::uint32_t>(octree_point_words *
                                                (octree_full_blocks(capacity) + octree_spare_points));
      memory.nodes = arena.take<OctreeNode>(OctreeNodes::nodes_for(fewer ? options.max_leaves : capacity));
      memory.counts = arena.take<std::uint32_t>(octree_sort_values);
      return memory;
    }
  };
  OctreeBuildResult add(const PointsView& points) noexcept;

  bool prepared_ = false;
  OctreeOptions options_;
  std::uint32_t capacity_ = 0;
  Memory memory_;
  OctreeNodes nodes_;
  detail::OctreeLeafGroups groups_;
  std::uint32_t size_ = 0, given_ = 0;  ///< given: points of all calls since build, those left out too
};

}  // namespace straightedge
