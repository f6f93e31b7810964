// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Every query against going through all points. The distances are the same sums, so results are compared
// without tolerance.
#include <algorithm>
#include <cmath>

#include "clouds.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

namespace {

struct Case {
  Points points;
  OctreeOptions options;
};

Case make_case(const std::string& kind, std::uint64_t seed, Pcg32& random) {
  constexpr double leaves[] = {0.05, 0.125, 1, 0.0101};
  Case c{test::cloud(kind, 1 + random.below(500), random), {.grid = {.leaf_m = leaves[seed % 4]}}};
  if (seed % 3 == 0) c.options.grid.origin = {0.3, -7.77, 1e3};
  if (kind == "huge") c.options.grid = fit_octree_grid(test::view(c.points), 1).grid;
  return c;
}

/// At points, at corners of cells, near, and far away.
Vector3 query(const Case& c, Pcg32& random) {
  const Vector3 at = test::position(c.points[random.below(static_cast<std::uint32_t>(c.points.size()))]);
  const Vector3 base = finite(at) ? at : Vector3{};
  const auto offset = [&](float half) { return test::position(test::in_box(random, half)); };
  switch (random.below(6)) {
    case 0:
      return base;
    case 1: {
      const auto eighth = [&](double v) { return std::floor(v * 8) / 8; };
      return {eighth(base.x), eighth(base.y), eighth(base.z)};
    }
    case 2:
      return base + offset(0.1F);
    case 3:
      return base + offset(3);
    case 4:
      return base + offset(1e5F);
    default:
      return base + offset(1e12F);
  }
}

std::vector<OctreeNeighbour> by_distance(const Case& c, const Vector3& from) {
  std::vector<OctreeNeighbour> all;
  for (const std::uint32_t i : test::kept(c.points, c.options.grid))
    all.push_back({i, squared_length(test::position(c.points[i]) - from)});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                    : a.index < b.index;
  });
  return all;
}

template <class Check>
void for_each_query(Check check) {
  for (const std::string& kind : test::kinds) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      Pcg32 random(seed);
      const Case c = make_case(kind, seed, random);
      Tree tree(c.points.size(), c.options);
      REQUIRE(tree.octree.build(test::view(c.points)).status == Status::ok);
      for (int i = 0; i < 20; ++i) {
        INFO(kind << ", seed " << seed << ", query " << i);
        check(c, tree.octree, query(c, random), random);
      }
    }
  }
}

}  // namespace

TEST_CASE("nearest is the nearest, of the lowest index") {
  for_each_query([](const Case& c, const Octree& octree, const Vector3& from, Pcg32& random) {
    const auto all = by_distance(c, from);
    OctreeNeighbour out;
    const OctreeFound found = octree.nearest(from, out);
    REQUIRE(found.status == Status::ok);
    REQUIRE(found.found == (all.empty() ? 0 : 1));
    if (all.empty()) return;
    REQUIRE(out == all[0]);
    // A limit that some point is exactly at, or that nothing reaches.
    const double limit =
        std::sqrt(all[random.below(static_cast<std::uint32_t>(all.size()))].squared_distance);
    REQUIRE(octree.nearest(from, out, limit).found == (all[0].squared_distance <= limit * limit ? 1 : 0));
    REQUIRE(octree.nearest(from, out, limit * 0.5).found ==
            (all[0].squared_distance <= limit * 0.5 * (limit * 0.5) ? 1 : 0));
  });
}

TEST_CASE("k nearest are the first k by distance and index") {
  for_each_query([](const Case& c, const Octree& octree, const Vector3& from, Pcg32& random) {
    auto all = by_distance(c, from);
    std::vector<OctreeNeighbour> out(1 + random.below(random.below(3) == 0 ? 600 : 12));
    const std::size_t k = std::min(out.size(), all.size());
    OctreeFound found = octree.k_nearest(from, out);
    REQUIRE(found.status == Status::ok);
    REQUIRE(found.found == k);
    REQUIRE(found.written == k);
    for (std::size_t i = 0; i < k; ++i) REQUIRE(out[i] == all[i]);
    if (all.empty()) return;
    const double limit = std::sqrt(all[k / 2].squared_distance);
    std::erase_if(all, [&](const OctreeNeighbour& n) { return n.squared_distance > limit * limit; });
    found = octree.k_nearest(from, out, limit);
    REQUIRE(found.found == std::min(out.size(), all.size()));
    for (std::size_t i = 0; i < found.found; ++i) REQUIRE(out[i] == all[i]);
  });
}

TEST_CASE("radius finds all points in the ball and no other") {
  for_each_query([](const Case& c, const Octree& octree, const Vector3& from, Pcg32& random) {
    auto all = by_distance(c, from);
    double radius = 0.3;
    if (!all.empty() && random.below(2) == 0)
      radius = std::sqrt(all[random.below(static_cast<std::uint32_t>(all.size()))].squared_distance);
    std::erase_if(all, [&](const OctreeNeighbour& n) { return n.squared_distance > radius * radius; });
    std::vector<OctreeNeighbour> out(c.points.size());
    const OctreeFound found = octree.radius(from, radius, out);
    REQUIRE(found.status == Status::ok);
    REQUIRE(found.found == all.size());
    out.resize(found.written);
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.before(b); });
    REQUIRE(out == all);
  });
}

TEST_CASE("box finds all points in the closed box and no other") {
  for_each_query([](const Case& c, const Octree& octree, const Vector3& from, Pcg32& random) {
    const float half = random.below(2) == 0 ? 0.125F : 2.0F;
    const auto side = [&] { return static_cast<double>(half) * random.below(9) / 8; };
    OctreeBox box{from, from + Vector3{side(), side(), side()}};
    if (random.below(8) == 0) box.max.y = octree_unlimited;
    if (random.below(8) == 0) box.min.z = -octree_unlimited;
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t i : test::kept(c.points, c.options.grid)) {
      const Vector3 p = test::position(c.points[i]);
      if (p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z &&
          p.z <= box.max.z)
        expected.push_back(i);
    }
    std::vector<std::uint32_t> out(c.points.size());
    const OctreeFound found = octree.box(box, out);
    REQUIRE(found.status == Status::ok);
    out.resize(found.written);
    std::sort(out.begin(), out.end());
    REQUIRE(out == expected);
  });
}

TEST_CASE("a point on its cell's border is found at exactly its distance") {
  // In cells the position is 699054 and a little, which is rounded to 2^-33 of a cell; a box that is not
  // widened by that would end farther away than the point in it.
  const Points points = {{0.5F, 0.03125F, 0.03125F}};
  Tree tree(1, {.grid = {.leaf_m = 0.1}});
  REQUIRE(tree.octree.build(test::view(points)).points == 1);
  for (int i = 0; i < 200; ++i) {
    const Vector3 from{0.4 + i * 1e-12, 0.03125, 0.03125};
    double distance = 0.5 - from.x;
    while (distance * distance < squared_length(test::position(points[0]) - from))
      distance = std::nextafter(distance, 1);
    OctreeNeighbour out;
    INFO(i);
    REQUIRE(tree.octree.radius(from, distance, {&out, 1}).found == 1);
    REQUIRE(tree.octree.nearest(from, out, distance).found == 1);
  }
}

TEST_CASE("range queries answer in the order of leaves, then of indices") {
  Pcg32 random(77);
  const Points points = test::cloud("random", 2000, random);
  Tree tree(points.size());
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  std::vector<std::uint32_t> place_of(points.size());
  for (std::uint32_t place = 0; place < tree.octree.size(); ++place)
    place_of[tree.octree.point(place).index] = place;
  std::vector<OctreeNeighbour> near(points.size());
  std::vector<std::uint32_t> inside(points.size());
  near.resize(tree.octree.radius({0, 0, 0}, 1, near).written);
  inside.resize(tree.octree.box({{-1, -1, -1}, {1, 1, 1}}, inside).written);
  REQUIRE(near.size() > 50);
  REQUIRE(inside.size() > near.size());
  for (std::size_t i = 1; i < near.size(); ++i) CHECK(place_of[near[i - 1].index] < place_of[near[i].index]);
  for (std::size_t i = 1; i < inside.size(); ++i) CHECK(place_of[inside[i - 1]] < place_of[inside[i]]);
}
