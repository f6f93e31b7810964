// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Leaves with many points: those that have boxes of their points. Answers against going through all points,
// and the same whether there is memory for the boxes or not.
#include <algorithm>

#include "clouds.hpp"
#include "straightedge/detail/octree_leaf_groups.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

namespace {

constexpr double leaf_m = 0.125;

/// Two walls, one of them oblique, and a table top, about 30 points a leaf; some points twice.
Points surfaces(std::size_t count, Pcg32& random) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const float a = test::unit(random), b = test::unit(random), noise = 0.004F * test::unit(random);
    if (i % 17 == 16) {
      points.push_back(points[random.below(static_cast<std::uint32_t>(i))]);
    } else if (i % 3 == 0) {
      points.push_back({a, b, 0.8F + noise});
    } else if (i % 3 == 1) {
      points.push_back({a, 0.5F * a + noise, b});
    } else {
      points.push_back({0.3F * a, -0.4F + noise, 0.3F * b});
    }
  }
  return points;
}

/// Near, at points themselves, at borders of groups, and where no group is.
Vector3 query(const Points& points, int i, Pcg32& random) {
  const Vector3 at = test::position(points[random.below(static_cast<std::uint32_t>(points.size()))]);
  if (i % 8 == 0) return at;
  if (i % 8 == 1) return {0.5, at.y, at.z};
  constexpr float halves[] = {0.01F, 0.1F, 0.3F, 1, 5, 0.05F};
  return at + test::position(test::in_box(random, halves[i % 6]));
}

std::vector<OctreeNeighbour> by_distance(const Points& points, const Vector3& from) {
  std::vector<OctreeNeighbour> all;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    all.push_back({i, squared_length(test::position(points[i]) - from)});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.before(b); });
  return all;
}

void check_queries(const Octree& octree, const Points& points, Pcg32& random) {
  for (int i = 0; i < 240; ++i) {
    INFO("query " << i);
    const Vector3 from = query(points, i, random);
    const auto all = by_distance(points, from);
    OctreeNeighbour out;
    REQUIRE(octree.nearest(from, out).found == 1);
    REQUIRE(out == all[0]);
    REQUIRE(octree.nearest(from, out, 0.05).found == (all[0].squared_distance <= 0.05 * 0.05 ? 1 : 0));
    std::vector<OctreeNeighbour> nearest(1 + random.below(i % 5 == 0 ? 200 : 9));
    REQUIRE(octree.k_nearest(from, nearest).found == nearest.size());
    for (std::size_t k = 0; k < nearest.size(); ++k) REQUIRE(nearest[k] == all[k]);
  }
}

}  // namespace

TEST_CASE("nearest points of crowded leaves, with boxes and without") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    Pcg32 random(seed);
    const Points points = surfaces(9000, random);
    OctreeOptions options{.grid = {.leaf_m = leaf_m}};
    if (seed == 2) options.grid.origin = {0.01, -3.3, 700};
    Tree roomy(points.size(), options);
    REQUIRE(roomy.octree.build(test::view(points)).status == Status::ok);
    check_queries(roomy.octree, points, random);

    options.max_leaves = roomy.octree.nodes().leaves();
    Tree tight(points.size(), options);
    REQUIRE(tight.octree.build(test::view(points)).status == Status::ok);
    check_queries(tight.octree, points, random);
  }
}

TEST_CASE("boxes are made anew by insert and forgotten by clear") {
  Pcg32 random(4);
  const Points points = surfaces(6000, random);
  Tree tree(points.size(), {.grid = {.leaf_m = leaf_m}});
  REQUIRE(tree.octree.build(test::view(Points(points.begin(), points.begin() + 5000))).status == Status::ok);
  REQUIRE(tree.octree.insert(test::view(Points(points.begin() + 5000, points.end()))).status == Status::ok);
  check_queries(tree.octree, points, random);
  tree.octree.clear();
  OctreeNeighbour out;
  CHECK(tree.octree.nearest({0, 0, 0.8}, out).found == 0);
}

TEST_CASE("a group is found by its cell, and has its leaves' points in their boxes") {
  Pcg32 random(5);
  const Points points = surfaces(8000, random);
  Tree tree(points.size(), {.grid = {.leaf_m = leaf_m}});
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  const Octree& octree = tree.octree;
  std::vector<std::uint32_t> sorted(octree_point_words * (octree_full_blocks(octree.size())));
  for (std::uint32_t i = 0; i < octree.size(); ++i) octree.point(i).write(sorted, i);

  using Groups = detail::OctreeLeafGroups;
  std::vector<std::uint32_t> memory(20'000);
  Groups groups;
  groups.build(octree.nodes(), octree.grid(), sorted, memory);
  REQUIRE(groups.groups > 8);
  for (std::uint32_t place = 0; place < octree.size(); ++place) {
    const Vector3 at = octree.grid().in_cells(octree.point(place).position());
    const double coordinates[] = {at.x, at.y, at.z};
    const std::uint32_t cell[] = {static_cast<std::uint32_t>(at.x) >> 2U,
                                  static_cast<std::uint32_t>(at.y) >> 2U,
                                  static_cast<std::uint32_t>(at.z) >> 2U};
    const std::uint32_t group = groups.find(Groups::address(cell[0], cell[1], cell[2]));
    REQUIRE(group < groups.groups);
    const auto last = groups.place.begin() + groups.first[group + 1];
    const auto leaf = static_cast<std::uint32_t>(
        std::upper_bound(groups.place.begin() + groups.first[group], last, place) - groups.place.begin() - 1);
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double unit = (coordinates[axis] - 4.0 * cell[axis]) * Groups::units_a_cell;
      REQUIRE(static_cast<double>(groups.low(leaf, axis)) <= unit);
      REQUIRE(static_cast<double>(groups.high(leaf, axis) + 1) >= unit);
    }
  }
  CHECK(groups.find(Groups::address(1, 1, 1)) == groups.groups);
  // Of another group both halves of the key are looked at, wherever the search for it begins.
  for (std::uint32_t group = 0; group < groups.groups; ++group) {
    MortonCell cell;
    REQUIRE(octree.grid().cell_of(octree.point(groups.place[groups.first[group]]).position(), cell));
    Groups::Address address = Groups::address(cell.x >> 2U, cell.y >> 2U, cell.z >> 2U);
    REQUIRE(groups.find(address) == group);
    address.key ^= std::uint64_t{1} << (group % 57);
    REQUIRE(groups.find(address) == groups.groups);
  }

  // Too little memory, or too few points in a leaf.
  groups.build(octree.nodes(), octree.grid(), sorted, std::span(memory).first(100));
  CHECK(groups.groups == 0);
  Tree fine(points.size(), {.grid = {.leaf_m = 0.01}});
  REQUIRE(fine.octree.build(test::view(points)).status == Status::ok);
  groups.build(fine.octree.nodes(), fine.octree.grid(), sorted, memory);
  CHECK(groups.groups == 0);
}
