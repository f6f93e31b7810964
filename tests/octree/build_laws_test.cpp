// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "clouds.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

namespace {

bool same_points(const Octree& a, const Octree& b) {
  if (a.size() != b.size()) return false;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    if (!(a.point(i) == b.point(i))) return false;
  return true;
}

Points part(const Points& points, std::size_t begin, std::size_t end) {
  return {points.begin() + static_cast<std::ptrdiff_t>(begin),
          points.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// What the header promises of the order, by a sort that anybody trusts.
std::vector<std::uint32_t> sorted_by_code(const Points& points, const OctreeGrid& grid) {
  std::vector<std::uint32_t> order = test::kept(points, grid);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    MortonCell cell_a, cell_b;
    (void)grid.cell_of(test::position(points[a]), cell_a);
    (void)grid.cell_of(test::position(points[b]), cell_b);
    return morton_encode(cell_a) < morton_encode(cell_b);
  });
  return order;
}

}  // namespace

TEST_CASE("the order of points is that of a stable sort by code") {
  for (const std::string& kind : test::kinds) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Pcg32 random(seed);
      const Points points = test::cloud(kind, 1 + random.below(700), random);
      const OctreeOptions options{.grid = {.leaf_m = seed % 2 == 0 ? 0.05 : 0.25}};
      Tree tree(points.size(), options);
      INFO(kind << ", seed " << seed);
      const OctreeBuildResult result = tree.octree.build(test::view(points));
      REQUIRE(result.status == Status::ok);
      const std::vector<std::uint32_t> order = sorted_by_code(points, options.grid);
      REQUIRE(result.points == order.size());
      REQUIRE(result.left_out == points.size() - order.size());
      for (std::uint32_t place = 0; place < order.size(); ++place)
        REQUIRE(tree.octree.point(place).index == order[place]);
    }
  }
}

TEST_CASE("inserting one by one, or piece by piece, equals building at once") {
  for (const std::string& kind : test::kinds) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Pcg32 random(seed);
      const Points points = test::cloud(kind, 300, random);
      // Few leaves are little room for merging, too: pieces of two leaves' nodes at a time.
      const OctreeOptions options{.grid = {.leaf_m = 0.125}};
      Tree at_once(points.size(), options);
      const OctreeBuildResult all = at_once.octree.build(test::view(points));
      REQUIRE(all.status == Status::ok);
      OctreeOptions tight = options;
      tight.max_leaves = all.leaves;
      Tree grown(points.size(), tight);
      INFO(kind << ", seed " << seed);
      for (std::size_t begin = 0; begin < points.size();) {
        const std::size_t piece = seed == 1 ? 1 : 1 + random.below(100);
        const std::size_t end = std::min(points.size(), begin + piece);
        REQUIRE(grown.octree.insert(test::view(part(points, begin, end))).status == Status::ok);
        begin = end;
      }
      CHECK(same_points(at_once.octree, grown.octree));
      CHECK(test::same_nodes(at_once.octree.nodes(), grown.octree.nodes()));
    }
  }
}

TEST_CASE("another order of the input changes nothing but the indices") {
  for (const std::string& kind : test::kinds) {
    Pcg32 random(9);
    const Points points = test::cloud(kind, 400, random);
    std::vector<std::uint32_t> order(points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::uint32_t i = static_cast<std::uint32_t>(order.size()); i > 1; --i)
      std::swap(order[i - 1], order[random.below(i)]);
    Points shuffled;
    for (const std::uint32_t i : order) shuffled.push_back(points[i]);
    Tree a(points.size()), b(points.size());
    REQUIRE(a.octree.build(test::view(points)).status == Status::ok);
    REQUIRE(b.octree.build(test::view(shuffled)).status == Status::ok);
    INFO(kind);
    REQUIRE(test::same_nodes(a.octree.nodes(), b.octree.nodes()));
    for (std::uint32_t leaf = 0; leaf < a.octree.nodes().size(); ++leaf) {
      if (!a.octree.nodes().is_leaf(leaf)) continue;
      std::set<std::uint32_t> in_a, in_b;
      for (std::uint32_t i = 0; i < a.octree.nodes().count_of(leaf); ++i) {
        in_a.insert(a.octree.point(a.octree.nodes()[leaf].first + i).index);
        in_b.insert(order[b.octree.point(b.octree.nodes()[leaf].first + i).index]);
      }
      REQUIRE(in_a == in_b);
    }
  }
}

TEST_CASE("a shift by whole leaves shifts every leaf") {
  Pcg32 random(10);
  Points points;
  // Multiples of 2^-10, so that the shift is exact in floats.
  const auto draw = [&] { return static_cast<float>(random.below(4096)) / 1024; };
  for (int i = 0; i < 500; ++i) points.push_back({draw(), draw(), draw()});
  Points shifted;
  for (const test::Point& p : points) shifted.push_back({p.x + 16, p.y - 2.5F, p.z + 0.125F});
  Tree a(points.size()), b(points.size());
  REQUIRE(a.octree.build(test::view(points)).status == Status::ok);
  REQUIRE(b.octree.build(test::view(shifted)).status == Status::ok);
  REQUIRE(a.octree.nodes().leaves() == b.octree.nodes().leaves());
  for (std::uint32_t i = 0; i < a.octree.nodes().size(); ++i) {
    if (!a.octree.nodes().is_leaf(i)) continue;
    MortonCell cell = morton_decode(a.octree.nodes()[i].code());
    cell = {cell.x + 128, cell.y - 20, cell.z + 1};
    const std::uint32_t there = b.octree.nodes().find(morton_encode(cell));
    REQUIRE(there < b.octree.nodes().size());
    REQUIRE(a.octree.nodes().count_of(i) == b.octree.nodes().count_of(there));
    for (std::uint32_t k = 0; k < a.octree.nodes().count_of(i); ++k)
      REQUIRE(a.octree.point(a.octree.nodes()[i].first + k).index ==
              b.octree.point(b.octree.nodes()[there].first + k).index);
  }
}
