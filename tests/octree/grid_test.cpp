// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "clouds.hpp"

using namespace straightedge;

TEST_CASE("cells are counted from the origin, and a border belongs to the upper cell") {
  const OctreeGrid grid{.origin = {10, 20, 30}, .leaf_m = 0.5};
  constexpr std::uint32_t o = octree_origin_cell;
  MortonCell cell;
  REQUIRE(grid.cell_of({10, 20, 30}, cell));
  CHECK(cell == MortonCell{o, o, o});
  REQUIRE(grid.cell_of({10.49, 20.5, 29.99}, cell));
  CHECK(cell == MortonCell{o, o + 1, o - 1});
}

TEST_CASE("the cube ends where the header says") {
  const OctreeGrid grid{.leaf_m = 2};
  const double low = -699'050.0 * 2, high = 1'398'102.0 * 2;
  MortonCell cell;
  CHECK(grid.cell_of({low, low, low}, cell));
  CHECK(cell == MortonCell{0, 0, 0});
  CHECK(grid.cell_of({high - 1, high - 1, high - 1}, cell));
  CHECK(cell == MortonCell{morton_side - 1, morton_side - 1, morton_side - 1});
  CHECK_FALSE(grid.cell_of({low - 1, 0, 0}, cell));
  CHECK_FALSE(grid.cell_of({0, high, 0}, cell));
  const double nan = std::nan(""), infinity = HUGE_VAL;
  for (const double bad : {nan, infinity, -infinity, 1e300, -1e300}) {
    CHECK_FALSE(grid.cell_of({bad, 0, 0}, cell));
    CHECK_FALSE(grid.cell_of({0, bad, 0}, cell));
    CHECK_FALSE(grid.cell_of({0, 0, bad}, cell));
  }
}

TEST_CASE("the box of a node holds its cells") {
  const OctreeGrid grid{.origin = {1, 2, 3}, .leaf_m = 0.25};
  constexpr std::uint32_t o = octree_origin_cell;  // even, and not a multiple of 4
  const std::uint64_t code = morton_encode({o + 3, o + 1, o});
  const OctreeBox leaf = grid.box_of(code, 0);
  CHECK(leaf.min == Vector3{1.75, 2.25, 3});
  CHECK(leaf.max == Vector3{2, 2.5, 3.25});
  const OctreeBox parent = grid.box_of(code, 1);
  CHECK(parent.min == Vector3{1.5, 2, 3});
  CHECK(parent.max == Vector3{2, 2.5, 3.5});
  const OctreeBox all = grid.box_of(code, morton_levels);
  CHECK(all.max.x - all.min.x == 0.25 * morton_side);
}

TEST_CASE("a fitted grid holds every finite point and gives a low tree") {
  for (const std::string& kind : test::kinds) {
    Pcg32 random(5);
    const test::Points points = test::cloud(kind, 400, random);
    const OctreeFit fit = fit_octree_grid(test::view(points), 0.05);
    INFO(kind);
    REQUIRE(fit.status == Status::ok);
    std::uint32_t finite_points = 0;
    for (const test::Point& p : points) {
      if (!finite(test::position(p))) continue;
      ++finite_points;
      MortonCell cell;
      CHECK(fit.grid.cell_of(test::position(p), cell));
      CHECK(test::position(p).x >= fit.box.min.x);
      CHECK(test::position(p).z <= fit.box.max.z);
    }
    CHECK(fit.points == finite_points);
    CHECK((fit.grid.leaf_m == 0.05 || kind == "huge" || kind == "wide apart"));
  }
}

TEST_CASE("a fitted room needs no more levels than its extent") {
  Pcg32 random(6);
  for (const float shift : {0.0F, 3.0F, 100.0F, -77.7F}) {
    test::Points points;
    for (int i = 0; i < 2000; ++i) {
      const test::Point p = test::in_box(random, 3.1F);
      points.push_back({p.x + shift, p.y - shift, p.z});
    }
    test::Tree tree(points.size(), {.grid = fit_octree_grid(test::view(points), 0.05).grid});
    REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
    CHECK(tree.octree.nodes()[0].level() == 7);  // 6.2 m are 124 leaves
  }
}

TEST_CASE("the smallest corner of a fitted box is in the first cell behind the middle, wherever it lies") {
  Pcg32 random(8);
  for (int i = 0; i < 300; ++i) {
    const test::Points points = {test::in_box(random, i < 150 ? 10.0F : 1e5F)};
    const OctreeFit fit = fit_octree_grid(test::view(points), 0.01 + 0.001 * random.below(100));
    MortonCell cell;
    REQUIRE(fit.grid.cell_of(test::position(points[0]), cell));
    REQUIRE(cell == MortonCell{morton_side / 2, morton_side / 2, morton_side / 2});
  }
}

TEST_CASE("fitting refuses what it cannot fit, and fits all floats") {
  test::Points points{{1, 2, 3}};
  CHECK(fit_octree_grid({}, 0.05).status == Status::invalid_image);
  for (const double leaf : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-10, 1e36})
    CHECK(fit_octree_grid(test::view(points), leaf).status == Status::invalid_option);
  points[0].y = std::nanf("");
  CHECK(fit_octree_grid(test::view(points), 0.05).status == Status::invalid_image);
  points = {{-3e38F, 0, 0}, {3e38F, 0, 0}};
  CHECK(fit_octree_grid(test::view(points), 0.05).grid.valid());
}
