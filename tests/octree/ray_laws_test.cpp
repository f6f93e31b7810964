// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "clouds.hpp"

using namespace straightedge;
using test::Points;
using test::Tree;

namespace {

/// Where a ray of unit direction is inside a box, by the slabs of its three axes, in the plainest way; a box
/// without length is none.
bool crosses(const OctreeBox& box, const OctreeRay& ray, double& enter, double& exit) {
  enter = 0;
  exit = ray.max_distance_m;
  const double origin[] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const double direction[] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const double min[] = {box.min.x, box.min.y, box.min.z}, max[] = {box.max.x, box.max.y, box.max.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < min[axis] || origin[axis] >= max[axis]) return false;
      continue;
    }
    const double a = (min[axis] - origin[axis]) / direction[axis];
    const double b = (max[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return enter < exit;
}

/// Any direction, or one along axes and diagonals.
Vector3 direction(Pcg32& random, bool regular) {
  const auto step = [&] { return static_cast<double>(random.below(3)) - 1; };
  Vector3 d;
  while (d == Vector3{})
    d = regular ? Vector3{step(), step(), step()} : test::position(test::in_box(random, 1));
  return normalized(d);
}

}  // namespace

TEST_CASE("a ray crosses the leaves whose boxes it crosses, in order") {
  for (const std::string kind : {"random", "clusters", "plane", "line", "borders", "single", "wide apart"}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      Pcg32 random(seed);
      const Points points = test::cloud(kind, 1 + random.below(400), random);
      const OctreeOptions options{.grid = {.leaf_m = seed % 2 == 0 ? 0.25 : 0.7}};
      Tree tree(points.size(), options);
      REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
      const OctreeNodes& nodes = tree.octree.nodes();
      for (int i = 0; i < 25; ++i) {
        INFO(kind << ", seed " << seed << ", ray " << i);
        OctreeRay ray{.origin = test::position(test::in_box(random, 4)),
                      .direction = direction(random, seed % 3 == 0)};
        // Towards a point, so that sparse clouds are hit as well.
        const Vector3 target =
            test::position(points[random.below(static_cast<std::uint32_t>(points.size()))]);
        if (i % 2 == 0 && target != ray.origin) ray.direction = normalized(target - ray.origin);
        if (i % 5 == 0) ray.max_distance_m = random.below(5);
        std::vector<OctreeCrossing> out(points.size());
        const OctreeFound found = tree.octree.ray(ray, out);
        REQUIRE(found.status == Status::ok);
        out.resize(found.written);

        std::vector<bool> met(nodes.size());
        for (std::size_t k = 0; k < out.size(); ++k) {
          REQUIRE(nodes.is_leaf(out[k].leaf));
          REQUIRE_FALSE(met[out[k].leaf]);
          met[out[k].leaf] = true;
          REQUIRE(out[k].enter_m < out[k].exit_m);
          if (k > 0) REQUIRE(out[k - 1].exit_m <= out[k].enter_m);
        }
        for (std::uint32_t n = 0; n < nodes.size(); ++n) {
          double enter = 0, exit = 0;
          if (!nodes.is_leaf(n)) continue;
          const bool crossed = crosses(options.grid.box_of(nodes[n].code(), 0), ray, enter, exit);
          // The two ways of computing it round differently; a nanometre of a corner may be there or not.
          if (std::fabs(exit - enter) < 1e-9 * (1 + std::fabs(enter))) continue;
          INFO("leaf " << n << " from " << enter << " to " << exit);
          REQUIRE(met[n] == crossed);
        }
        for (const OctreeCrossing& crossing : out) {
          double enter = 0, exit = 0;
          (void)crosses(options.grid.box_of(nodes[crossing.leaf].code(), 0), ray, enter, exit);
          REQUIRE(crossing.enter_m == Approx(enter).margin(1e-9));
          REQUIRE(crossing.exit_m == Approx(exit).margin(1e-9));
        }
        OctreeCrossing first;
        REQUIRE(tree.octree.first_hit(ray, first).found == (out.empty() ? 0 : 1));
        if (!out.empty()) REQUIRE(first.leaf == out[0].leaf);
      }
    }
  }
}

TEST_CASE("in a full grid a ray meets the cells of a walk from cell to cell") {
  // 16 x 16 x 16 cells of 1 m, one point in each.
  Points points;
  for (int i = 0; i < 4096; ++i)
    points.push_back({static_cast<float>(i % 16) + 0.5F, static_cast<float>(i / 16 % 16) + 0.5F,
                      static_cast<float>(i / 256) + 0.5F});
  Tree tree(points.size(), {.grid = {.leaf_m = 1}});
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  Pcg32 random(5);
  for (int i = 0; i < 300; ++i) {
    OctreeRay ray{.origin = Vector3{8, 8, 8} + test::position(test::in_box(random, 8)),
                  .direction = direction(random, false)};
    std::vector<OctreeCrossing> out(64);
    out.resize(tree.octree.ray(ray, out).written);
    REQUIRE_FALSE(out.empty());
    REQUIRE(out.size() < 64);
    // Each step goes through one face, without a gap, until the ray leaves the grid.
    REQUIRE(out[0].enter_m == 0);
    for (std::size_t k = 1; k < out.size(); ++k) {
      const MortonCell a = morton_decode(tree.octree.nodes()[out[k - 1].leaf].code());
      const MortonCell b = morton_decode(tree.octree.nodes()[out[k].leaf].code());
      const auto apart = [](std::uint32_t s, std::uint32_t t) { return s < t ? t - s : s - t; };
      REQUIRE(apart(a.x, b.x) + apart(a.y, b.y) + apart(a.z, b.z) == 1);
      REQUIRE(out[k].enter_m == out[k - 1].exit_m);
    }
    const Vector3 end = ray.origin + out.back().exit_m * ray.direction;
    const double outside = std::max({std::fabs(end.x - 8), std::fabs(end.y - 8), std::fabs(end.z - 8)});
    REQUIRE(outside == Approx(8));
  }
}

TEST_CASE("rays along borders: faces belong to the upper cell, corners and ends to none") {
  Points points;
  for (int i = 0; i < 27; ++i)
    points.push_back({static_cast<float>(i % 3) + 0.5F, static_cast<float>(i / 3 % 3) + 0.5F,
                      static_cast<float>(i / 9) + 0.5F});
  Tree tree(points.size(), {.grid = {.leaf_m = 1}});
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  const auto cells = [&](const OctreeRay& ray) {
    std::vector<OctreeCrossing> out(27);
    out.resize(tree.octree.ray(ray, out).written);
    std::vector<std::uint32_t> indices;
    for (const OctreeCrossing& c : out)
      indices.push_back(tree.octree.point(tree.octree.nodes()[c.leaf].first).index);
    return indices;
  };
  using Cells = std::vector<std::uint32_t>;
  CHECK(cells({.origin = {-1, 1, 1}, .direction = {2, 0, 0}}) == Cells{12, 13, 14});
  CHECK(cells({.origin = {4, 1, 1}, .direction = {-5, 0, 0}}) == Cells{14, 13, 12});
  CHECK(cells({.origin = {-1, -1, -1}, .direction = {1, 1, 1}}) == Cells{0, 13, 26});
  CHECK(cells({.origin = {-1, 2, 0.5}, .direction = {1, -1, 0}}) == Cells{0});  // through (0, 1), (1, 0)
  CHECK(cells({.origin = {1, 0.5, 0.5}, .direction = {-1, 0, 0}}) == Cells{0});
  CHECK(cells({.origin = {0.5, 0.5, 0.5}, .direction = {1, 0, 0}, .max_distance_m = 0.5}) == Cells{0});
  CHECK(cells({.origin = {0.5, 0.5, 0.5}, .direction = {1, 0, 0}, .max_distance_m = 0}) == Cells{});
  CHECK(cells({.origin = {-1, 3, 0.5}, .direction = {1, 0, 0}}) == Cells{});
  CHECK(cells({.origin = {5, 0.5, 0.5}, .direction = {1, 0, 0}}) == Cells{});
}
