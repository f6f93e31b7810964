// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "clouds.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

TEST_CASE("points lie sorted by leaf, each leaf's in the order of their indices") {
  const Points points = {{1, 0, 0}, {0, 0, 0}, {1.01F, 0, 0}, {0, 1, 0}, {0.02F, 0, 0}, {0, 0, 1}};
  Tree tree(points.size());
  const OctreeBuildResult result = tree.octree.build(test::view(points));
  CHECK(result.status == Status::ok);
  CHECK(result.points == 6);
  CHECK(result.left_out == 0);
  CHECK(result.leaves == 4);
  const std::uint32_t order[] = {1, 4, 0, 2, 3, 5};
  for (std::uint32_t place = 0; place < 6; ++place) {
    const OctreePoint p = tree.octree.point(place);
    CHECK(p.index == order[place]);
    CHECK(p.x == points[p.index].x);
    CHECK(p.y == points[p.index].y);
    CHECK(p.z == points[p.index].z);
  }
}

TEST_CASE("structs of arrays and arrays of structs give the same octree") {
  Pcg32 random(3);
  const Points points = test::cloud("clusters", 300, random);
  std::vector<float> x, y, z;
  for (const test::Point& p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  PointsView arrays;
  arrays.x = x.data();
  arrays.y = y.data();
  arrays.z = z.data();
  arrays.count = x.size();
  Tree a(points.size()), b(points.size());
  REQUIRE(a.octree.build(test::view(points)).status == Status::ok);
  REQUIRE(b.octree.build(arrays).status == Status::ok);
  CHECK(test::same_nodes(a.octree.nodes(), b.octree.nodes()));
  for (std::uint32_t i = 0; i < a.octree.size(); ++i) CHECK(a.octree.point(i) == b.octree.point(i));
}

TEST_CASE("points outside the cube or not finite are counted and keep their place in the numbering") {
  const float nan = std::nanf("");
  const Points points = {{nan, 0, 0}, {1, 1, 1}, {0, HUGE_VALF, 0}, {3e38F, 0, 0}, {1, 1, 1.01F}};
  Tree tree(2);
  const OctreeBuildResult result = tree.octree.build(test::view(points));
  CHECK(result.status == Status::ok);
  CHECK(result.points == 2);
  CHECK(result.left_out == 3);
  CHECK(tree.octree.point(0).index == 1);
  CHECK(tree.octree.point(1).index == 4);
}

TEST_CASE("a point that is left out parts others of its neighbours' cell, also of the first cell of all") {
  const float nan = std::nanf("");
  constexpr double o = octree_origin_cell;
  const Points points = {{0.5F, 0, 0}, {nan, 0, 0}, {0.25F, 0, 0}, {nan, nan, nan}, {0.75F, 0, 0}};
  Tree tree(3, {.grid = {.origin = {o, o, o}, .leaf_m = 1}});
  REQUIRE(tree.octree.build(test::view(points)).points == 3);
  REQUIRE(tree.octree.nodes()[0].code() == 0);
  CHECK(tree.octree.point(0).index == 0);
  CHECK(tree.octree.point(1).index == 2);
  CHECK(tree.octree.point(2).index == 4);
}

TEST_CASE("no points, or none that counts, is an empty octree") {
  const Points nothing = {{std::nanf(""), 0, 0}};
  Tree tree(4);
  for (const PointsView& view : {PointsView{}, test::view(nothing)}) {
    const OctreeBuildResult result = tree.octree.build(view);
    CHECK(result.status == Status::ok);
    CHECK(result.points == 0);
    CHECK(result.left_out == view.count);
    CHECK(result.leaves == 0);
    CHECK(tree.octree.nodes().size() == 0);
    OctreeNeighbour out;
    CHECK(tree.octree.nearest({0, 0, 0}, out).status == Status::ok);
    CHECK(tree.octree.nearest({0, 0, 0}, out).found == 0);
    CHECK(tree.octree.k_nearest({0, 0, 0}, {&out, 1}).found == 0);
    CHECK(tree.octree.radius({0, 0, 0}, 1e9, {}).found == 0);
    CHECK(tree.octree.box({{-9, -9, -9}, {9, 9, 9}}, {}).found == 0);
    CHECK(tree.octree.ray({.direction = {1, 0, 0}}, {}).found == 0);
  }
}

TEST_CASE("a build that is full leaves the octree empty, an insert that is full as it was") {
  Pcg32 random(4);
  const Points points = test::cloud("random", 50, random);
  Tree tree(60);
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  const std::uint32_t leaves = tree.octree.nodes().leaves();
  const OctreeBuildResult full = tree.octree.insert(test::view(points));
  CHECK(full.status == Status::size_mismatch);
  CHECK(full.points == 0);
  CHECK(full.leaves == leaves);
  CHECK(tree.octree.size() == 50);
  OctreeNeighbour out;
  for (std::uint32_t i = 0; i < 50; ++i) {
    REQUIRE(tree.octree.nearest(test::position(points[i]), out).found == 1);
    CHECK(out.index == i);
  }
  REQUIRE(tree.octree.insert(test::view({points[7]})).status == Status::ok);
  CHECK(tree.octree.radius(test::position(points[7]), 0, {&out, 1}).found == 2);
  CHECK(out.index == 7);

  Tree small(49);
  REQUIRE(small.octree.build(test::view({points[0]})).status == Status::ok);
  CHECK(small.octree.build(test::view(points)).status == Status::size_mismatch);
  CHECK(small.octree.size() == 0);
  CHECK(small.octree.nodes().size() == 0);
}

TEST_CASE("more leaves than were asked for: the result says how many there are") {
  Points points;
  for (int i = 0; i < 20; ++i) points.push_back({static_cast<float>(i / 2), 0, 0});
  Tree enough(20, {.grid = {.leaf_m = 0.5}, .max_leaves = 10});
  CHECK(enough.octree.build(test::view(points)).status == Status::ok);
  Tree few(20, {.grid = {.leaf_m = 0.5}, .max_leaves = 9});
  const OctreeBuildResult result = few.octree.build(test::view(points));
  CHECK(result.status == Status::workspace_too_small);
  CHECK(result.leaves == 10);
  CHECK(result.points == 0);
  CHECK(few.octree.size() == 0);

  REQUIRE(few.octree.build(test::view(Points(points.begin(), points.begin() + 9))).status == Status::ok);
  const OctreeBuildResult inserted = few.octree.insert(test::view(Points(points.begin() + 9, points.end())));
  CHECK(inserted.status == Status::workspace_too_small);
  CHECK(inserted.leaves == 10);
  CHECK(few.octree.size() == 9);
  CHECK(few.octree.nodes().leaves() == 5);
  OctreeNeighbour out;
  REQUIRE(few.octree.nearest({100, 0, 0}, out).found == 1);
  CHECK(out.index == 8);
}

TEST_CASE("build forgets, clear forgets") {
  Tree tree(4);
  REQUIRE(tree.octree.build(test::view({{1, 1, 1}, {2, 2, 2}})).status == Status::ok);
  REQUIRE(tree.octree.build(test::view({{3, 3, 3}})).status == Status::ok);
  CHECK(tree.octree.size() == 1);
  CHECK(tree.octree.point(0).index == 0);
  tree.octree.clear();
  CHECK(tree.octree.size() == 0);
  CHECK(tree.octree.nodes().size() == 0);
  REQUIRE(tree.octree.insert(test::view({{3, 3, 3}})).status == Status::ok);
  CHECK(tree.octree.point(0).index == 0);
}

TEST_CASE("16 bytes a point and 32 a leaf") {
  constexpr OctreeOptions eighth{.max_leaves = 300'000 / 8};
  constexpr std::size_t bytes = Octree::workspace_bytes(300'000, eighth);
  CHECK(bytes <= 300'000 * 20 + 10'000);
  CHECK(Octree::workspace_bytes(300'000, {}) <= 300'000 * 48 + 10'000);
}
