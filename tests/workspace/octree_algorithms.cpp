// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "algorithms.hpp"
#include "inputs.hpp"
#include "straightedge/octree.hpp"

namespace workspace {
namespace {

constexpr OctreeOptions options{.grid = {.origin = {}, .leaf_m = 0.1}, .max_leaves = 0};

void say(CallerMemory& memory, const OctreeNodes& nodes) {
  memory.say({nodes.leaves() * 1.0, nodes.points() * 1.0});
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    memory.say({static_cast<double>(nodes[i].key), nodes[i].first * 1.0, nodes[i].next * 1.0});
  }
}

Status ask(CallerMemory& memory, const Octree& octree) {
  const Vector3 middle{0.1, 0.1, 2.5};
  const auto near = memory.list<OctreeNeighbour>(20);
  const auto nearest = octree.k_nearest(middle, near);
  for (const OctreeNeighbour& n : near.first(nearest.written))
    memory.say({n.index * 1.0, n.squared_distance});
  const auto ball = memory.list<OctreeNeighbour>(2000);
  const auto inside = octree.radius({0, 0, 3.2}, 0.5, ball);
  for (const OctreeNeighbour& n : ball.first(inside.written)) memory.say({n.index * 1.0});
  const auto boxed = memory.list<std::uint32_t>(2000);
  const auto box = octree.box({{-0.5, -0.5, 3}, {0, 0, 3.5}}, boxed);
  for (const std::uint32_t index : boxed.first(box.written)) memory.say({index * 1.0});
  const auto crossings = memory.list<OctreeCrossing>(10);
  const auto ray = octree.ray({.direction = {0.1, 0.05, 1}}, crossings);
  for (const OctreeCrossing& c : crossings.first(ray.written))
    memory.say({c.leaf * 1.0, c.enter_m, c.exit_m});
  for (const Status status : {nearest.status, inside.status, box.status, ray.status}) {
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

Status run_octree(CallerMemory& memory) {
  const PointsView points = memory.input(cloud());
  const auto capacity = static_cast<std::uint32_t>(2 * points.count);
  Octree octree;
  const Status prepared = Octree::prepare(octree, capacity, options,
                                          memory.workspace(Octree::workspace_bytes(capacity, options)));
  const OctreeBuildResult built = octree.build(points);
  const Status grown = built.status == Status::ok ? octree.insert(points).status : built.status;
  say(memory, octree.nodes());
  const Status asked = ask(memory, octree);
  return whole(prepared, grown == Status::ok ? asked : grown);
}

Status run_nodes(CallerMemory& memory) {
  const std::uint64_t codes[] = {1, 1, 2, 9, 77, 78, 4711, 4711, 1'000'000, 1'000'007};
  Arena needed = Arena::measure();
  needed.take<OctreeNode>(OctreeNodes::nodes_for(8));
  Arena arena(memory.workspace(needed.used()));
  OctreeNodes nodes;
  const Status status = OctreeNodes::build(nodes, codes, arena.take<OctreeNode>(OctreeNodes::nodes_for(8)));
  say(memory, nodes);
  return status;
}

constexpr Algorithm algorithms[] = {
    {"octree", run_octree},
    {"octree nodes", run_nodes},
};

}  // namespace

std::span<const Algorithm> octree_algorithms() {
  return algorithms;
}

}  // namespace workspace
