// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/code_reader.hpp"
#include "octree/copy_points.hpp"
#include "octree/merge_points.hpp"
#include "octree/sort_points.hpp"
#include "straightedge/octree.hpp"

namespace straightedge {
namespace {

void list_leaves(const OctreeGrid& grid, std::span<const std::uint32_t> words, std::uint32_t points,
                 std::span<OctreeNode> memory) noexcept {
  octree::CodeReader reader(grid);
  std::uint32_t leaves = 0;
  std::uint64_t last = morton_codes;
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::uint64_t code = reader.code_of(OctreePoint::read(words, i).position());
    if (code != last) memory[leaves++] = {OctreeNode::key_of(code, 0), i, 0};
    last = code;
  }
}

/// Queries look at whole blocks; nothing is near to what is not there.
void fill_block(std::span<std::uint32_t> words, std::size_t points) noexcept {
  constexpr float nowhere = std::numeric_limits<float>::infinity();
  for (std::size_t i = points; i < octree_full_blocks(points); ++i)
    OctreePoint{nowhere, nowhere, nowhere, UINT32_MAX}.write(words, i);
}

}  // namespace

Status Octree::prepare(Octree& octree, std::uint32_t capacity, const OctreeOptions& options,
                       std::span<std::byte> workspace) noexcept {
  octree = Octree();
  const Status status = options.kernels == nullptr ? Status::invalid_option : check(capacity, options);
  if (status != Status::ok) return status;
  Arena arena(workspace);
  octree.memory_ = Memory::take(arena, capacity, options);
  if (arena.failed()) {
    octree.memory_ = Memory();
    return Status::workspace_too_small;
  }
  octree.options_ = options;
  octree.capacity_ = capacity;
  octree.prepared_ = true;
  return Status::ok;
}

void Octree::clear() noexcept {
  nodes_ = OctreeNodes();
  groups_ = detail::OctreeLeafGroups();
  size_ = 0;
  given_ = 0;
}

OctreeBuildResult Octree::build(const PointsView& points) noexcept {
  clear();
  return insert(points);
}

OctreeBuildResult Octree::insert(const PointsView& points) noexcept {
  OctreeBuildResult result;
  result.leaves = nodes_.leaves();
  if (!prepared_) return result;
  result.status = Status::ok;
  if (points.count == 0) return result;
  result.status = Status::invalid_image;
  if (!points.valid()) return result;
  result.status = Status::too_large;
  if (points.count > UINT32_MAX - given_) return result;
  return add(points);
}

OctreeBuildResult Octree::add(const PointsView& points) noexcept {
  OctreeBuildResult result;
  result.leaves = nodes_.leaves();

  // Steps 1 to 3, behind the points that are there.
  const std::size_t new_place = octree_full_blocks(size_);
  const std::span<std::uint32_t> behind = memory_.points.subspan(octree_point_words * new_place);
  const octree::SortedRuns runs =
      octree::sort_runs(points, options_.grid, *options_.kernels, capacity_ - size_, behind, memory_.counts);
  result.status = Status::size_mismatch;
  if (!runs.fit) return result;
  octree::copy_points(runs, points, options_.grid, given_, behind,
                      [&](std::uint64_t code, std::uint32_t place) {
                        if (size_ > 0 && nodes_.find(code) < nodes_.size()) return;
                        // Step 5 of a build; the nodes of an insert are still needed here.
                        if (size_ == 0 && OctreeNodes::nodes_for(result.leaves + 1) <= memory_.nodes.size())
                          memory_.nodes[result.leaves] = {OctreeNode::key_of(code, 0), place, 0};
                        ++result.leaves;
                      });
  result.status = Status::workspace_too_small;
  if (OctreeNodes::nodes_for(result.leaves) > memory_.nodes.size()) return result;

  if (size_ > 0) {
    // Step 4: from here on the nodes are gone, and their memory is free.
    octree::merge_points(options_.grid, memory_.points, size_, static_cast<std::uint32_t>(new_place),
                         runs.points, memory_.nodes);

    // Step 5
    list_leaves(options_.grid, memory_.points, size_ + runs.points, memory_.nodes);
  }
  size_ += runs.points;
  fill_block(memory_.points, size_);
  given_ += static_cast<std::uint32_t>(points.count);
  nodes_ = OctreeNodes::link(memory_.nodes, result.leaves, size_);

  // Step 6
  const std::span<OctreeNode> left = memory_.nodes.subspan(nodes_.size() + 1);
  groups_.build(nodes_, options_.grid, memory_.points,
                {reinterpret_cast<std::uint32_t*>(left.data()), left.size_bytes() / sizeof(std::uint32_t)});
  result.status = Status::ok;
  result.points = runs.points;
  result.left_out = static_cast<std::uint32_t>(points.count) - runs.points;
  return result;
}

}  // namespace straightedge
