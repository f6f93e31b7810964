// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Points in one array of structs and in three arrays take different ways into the octree, and blocks that are
// not full have places that nothing may be read from.
#include <algorithm>

#include "clouds.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

namespace {

struct Columns {
  std::vector<float> x, y, z;

  explicit Columns(const Points& points) {
    for (const test::Point& p : points) {
      x.push_back(p.x);
      y.push_back(p.y);
      z.push_back(p.z);
    }
  }
  PointsView view(std::size_t begin, std::size_t end) const {
    PointsView v;
    v.x = x.data() + begin;
    v.y = y.data() + begin;
    v.z = z.data() + begin;
    v.count = end - begin;
    return v;
  }
};

/// Like a scan: points of one cell follow one another, up to a hundred of them, and some are no readings.
Points scan(std::size_t count, Pcg32& random) {
  Points points;
  while (points.size() < count) {
    const test::Point corner = test::in_box(random, 2);
    const float side = random.below(5) == 0 ? 0.3F : 0.01F;
    const float gone = random.below(9) == 0 ? std::numeric_limits<float>::quiet_NaN() : 0;
    for (std::uint32_t left = 1 + random.below(100); left > 0 && points.size() < count; --left) {
      const test::Point d = test::in_box(random, side);
      points.push_back({corner.x + d.x, corner.y + d.y + gone, corner.z + d.z});
    }
  }
  return points;
}

Points cloud(const std::string& kind, std::size_t count, Pcg32& random) {
  return kind == "scan" ? scan(count, random) : test::cloud(kind, count, random);
}

std::vector<std::string> kinds() {
  std::vector<std::string> all = test::kinds;
  all.push_back("scan");
  return all;
}

void require_same(const Octree& a, const Octree& b) {
  REQUIRE(a.size() == b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) REQUIRE(a.point(i) == b.point(i));
  REQUIRE(test::same_nodes(a.nodes(), b.nodes()));
}

OctreeNeighbour by_brute_force(const Points& points, const OctreeGrid& grid, const Vector3& at) {
  OctreeNeighbour best{UINT32_MAX, octree_unlimited};
  for (const std::uint32_t i : test::kept(points, grid)) {
    const OctreeNeighbour here{i, squared_length(test::position(points[i]) - at)};
    if (here.before(best)) best = here;
  }
  return best;
}

}  // namespace

TEST_CASE("three arrays give the tree that an array of structs gives") {
  for (const std::string& kind : kinds()) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Pcg32 random(seed);
      const Points points = cloud(kind, 1 + random.below(900), random);
      const Columns columns(points);
      INFO(kind << ", seed " << seed);
      Tree structs(points.size()), arrays(points.size());
      REQUIRE(structs.octree.build(test::view(points)).status == Status::ok);
      REQUIRE(arrays.octree.build(columns.view(0, points.size())).status == Status::ok);
      require_same(arrays.octree, structs.octree);
    }
  }
}

TEST_CASE("a scan is sorted like any cloud, and pieces of it make the same tree") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Pcg32 random(seed);
    const Points points = scan(1 + random.below(2000), random);
    const Columns columns(points);
    const OctreeOptions options{.grid = {.leaf_m = 0.125}};
    INFO("seed " << seed);
    Tree whole(points.size(), options), pieces(points.size(), options);
    REQUIRE(whole.octree.build(columns.view(0, points.size())).status == Status::ok);

    std::vector<std::uint32_t> order = test::kept(points, options.grid);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      MortonCell cell_a, cell_b;
      (void)options.grid.cell_of(test::position(points[a]), cell_a);
      (void)options.grid.cell_of(test::position(points[b]), cell_b);
      return morton_encode(cell_a) < morton_encode(cell_b);
    });
    REQUIRE(whole.octree.size() == order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) REQUIRE(whole.octree.point(i).index == order[i]);

    for (std::size_t begin = 0; begin < points.size();) {
      const std::size_t end = std::min<std::size_t>(points.size(), begin + 1 + random.below(500));
      REQUIRE(pieces.octree.insert(columns.view(begin, end)).status == Status::ok);
      begin = end;
    }
    require_same(pieces.octree, whole.octree);
  }
}

TEST_CASE("what an earlier cloud left in a block is nobody's neighbour") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed);
    const Points near = test::cloud("random", 200, random);
    const Points far = test::cloud("far", 1 + random.below(9), random);
    Tree tree(near.size());
    INFO("seed " << seed);
    REQUIRE(tree.octree.build(test::view(near)).status == Status::ok);
    REQUIRE(tree.octree.build(test::view(far)).status == Status::ok);
    for (int i = 0; i < 20; ++i) {
      const Vector3 at = test::position(test::in_box(random, 2));
      OctreeNeighbour found;
      REQUIRE(tree.octree.nearest(at, found).found == 1);
      REQUIRE(found == by_brute_force(far, tree.octree.grid(), at));
    }
  }
}
