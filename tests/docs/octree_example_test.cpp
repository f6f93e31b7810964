// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The example that docs/octree.md works out by hand. Whoever changes a number here changes it there.
#include <array>
#include <cstdint>
#include <vector>

#include "straightedge/octree.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr std::array<float, 12> points = {3.5F, 1.5F, 0, 0.2F, 0.7F, 0, 3.1F, 1.9F, 0, 2.5F, 0.5F, 0};
enum Name : std::uint32_t { a, b, c, d };

/// The origin is where cell (0, 0, 0) has its corner.
constexpr double o = octree_origin_cell;
constexpr OctreeOptions options{.grid = {.origin = {o, o, o}, .leaf_m = 1}};

struct Example {
  Example() : memory(Octree::workspace_bytes(4, options)) {
    REQUIRE(Octree::prepare(octree, 4, options, memory) == Status::ok);
    PointsView view;
    view.x = &points[0];
    view.y = &points[1];
    view.z = &points[2];
    view.count = 4;
    view.stride = 3 * sizeof(float);
    REQUIRE(octree.build(view).points == 4);
  }
  std::vector<std::byte> memory;
  Octree octree;
};

}  // namespace

TEST_CASE("octree.md: codes, order and nodes of four points") {
  const Example example;
  const Octree& octree = example.octree;
  CHECK(morton_encode({3, 1, 0}) == 11);
  CHECK(morton_encode({2, 0, 0}) == 8);
  const Name order[] = {b, d, a, c};
  for (std::uint32_t i = 0; i < 4; ++i) CHECK(octree.point(i).index == order[i]);
  struct Row {
    std::uint64_t code;
    int level;
    std::uint32_t first, count, next;
  };
  const Row table[] = {{0, 2, 0, 4, 5}, {0, 0, 0, 1, 2}, {8, 1, 1, 3, 5}, {8, 0, 1, 1, 4}, {11, 0, 2, 2, 5}};
  const OctreeNodes& nodes = octree.nodes();
  REQUIRE(nodes.size() == 5);
  for (std::uint32_t i = 0; i < 5; ++i) {
    INFO("node " << i);
    CHECK(nodes[i].code() == table[i].code);
    CHECK(nodes[i].level() == table[i].level);
    CHECK(nodes[i].first == table[i].first);
    CHECK(nodes.count_of(i) == table[i].count);
    CHECK(nodes[i].next == table[i].next);
  }
}

TEST_CASE("octree.md: the nearest point to (3, 2, 0), and a ray along x") {
  const Example example;
  OctreeNeighbour nearest;
  REQUIRE(example.octree.nearest({3, 2, 0}, nearest).found == 1);
  CHECK(nearest.index == c);
  CHECK(nearest.squared_distance == Approx(0.02));
  std::array<OctreeCrossing, 4> crossings;
  REQUIRE(example.octree.ray({.origin = {-1, 0.5, 0}, .direction = {1, 0, 0}}, crossings).found == 2);
  CHECK(crossings[0].leaf == 1);
  CHECK(crossings[0].enter_m == 1);
  CHECK(crossings[0].exit_m == 2);
  CHECK(crossings[1].leaf == 3);
  CHECK(crossings[1].enter_m == 3);
  CHECK(crossings[1].exit_m == 4);
}
