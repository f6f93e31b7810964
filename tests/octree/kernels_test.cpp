// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>
#include <string>

#include "clouds.hpp"
#include "straightedge/host/kernels.hpp"

using namespace straightedge;

namespace {

constexpr OctreeAxis axis{0.3, 20, octree_origin_cell, morton_side};

/// Coordinates in a room, at the borders of the cube, and some that are nowhere.
float coordinate(Pcg32& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float odd[] = {-34952.2F, -34952.25F, 69905.4F,
                           69905.39F, 1e30F,      -1e30F,
                           infinity,  -infinity,  std::numeric_limits<float>::quiet_NaN(),
                           0.3F};
  return random.below(10) == 0 ? odd[random.below(10)] : 8 * test::unit(random);
}

}  // namespace

TEST_CASE("every set of kernels finds the cells that the plain one finds") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::size_t count = 0; count <= 200; ++count) {
      CAPTURE(std::string(set.name), count);
      Pcg32 random(count);
      std::vector<float> coordinates(count);
      for (float& c : coordinates) c = coordinate(random);
      std::vector<std::int32_t> cells(count + 1, 7), expected(count + 1, 7);
      set.octree->cells(coordinates.data(), count, axis, cells.data());
      plain_octree_kernels.cells(coordinates.data(), count, axis, expected.data());
      REQUIRE(cells == expected);
    }
  }
}

TEST_CASE("kernels find the cells that a grid finds") {
  const OctreeGrid grid{.origin = {0.3, 0.3, 0.3}, .leaf_m = 0.05};
  Pcg32 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const float c = coordinate(random);
    std::int32_t found = 0;
    plain_octree_kernels.cells(&c, 1, {0.3, 1 / grid.leaf_m, octree_origin_cell, morton_side}, &found);
    MortonCell cell;
    const bool inside = grid.cell_of({static_cast<double>(c), 0, 0}, cell);
    CAPTURE(i, c);
    REQUIRE(found == (inside ? static_cast<std::int32_t>(cell.x) : -1));
  }
}

TEST_CASE("an octree is the same with every set of kernels") {
  Pcg32 random(2);
  test::Points points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({coordinate(random), test::unit(random), test::unit(random)});
  test::Tree plain(points.size());
  const OctreeBuildResult expected = plain.octree.build(test::view(points));
  REQUIRE(expected.status == Status::ok);
  for (const KernelSet& set : kernel_sets()) {
    CAPTURE(std::string(set.name));
    test::Tree tree(points.size(), {.grid = {.leaf_m = 0.125}, .kernels = set.octree});
    const OctreeBuildResult result = tree.octree.build(test::view(points));
    CHECK(result.points == expected.points);
    CHECK(result.leaves == expected.leaves);
    REQUIRE(tree.octree.size() == plain.octree.size());
    for (std::uint32_t i = 0; i < plain.octree.size(); ++i)
      REQUIRE(tree.octree.point(i) == plain.octree.point(i));
  }
}
