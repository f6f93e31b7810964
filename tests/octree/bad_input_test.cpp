// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "clouds.hpp"

using namespace straightedge;

namespace {

const double not_a_number = std::nan("");
constexpr double infinite = octree_unlimited;

}  // namespace

TEST_CASE("prepare refuses bad options and too little memory") {
  std::vector<std::byte> memory(Octree::workspace_bytes(10, {}));
  Octree octree;
  for (const double leaf : {0.0, -0.05, not_a_number, infinite, 1e-10, 1e36}) {
    const OctreeOptions options{.grid = {.leaf_m = leaf}};
    CHECK(Octree::workspace_bytes(10, options) == 0);
    CHECK(Octree::prepare(octree, 10, options, memory) == Status::invalid_option);
  }
  for (const double bad : {not_a_number, infinite, -infinite, 1e43}) {
    CHECK(Octree::prepare(octree, 10, {.grid = {.origin = {bad, 0, 0}}}, memory) == Status::invalid_option);
    CHECK(Octree::prepare(octree, 10, {.grid = {.origin = {0, bad, 0}}}, memory) == Status::invalid_option);
    CHECK(Octree::prepare(octree, 10, {.grid = {.origin = {0, 0, bad}}}, memory) == Status::invalid_option);
  }
  CHECK(Octree::prepare(octree, 10, {.kernels = nullptr}, memory) == Status::invalid_option);
  CHECK(Octree::prepare(octree, 0, {}, memory) == Status::too_large);
  CHECK(Octree::prepare(octree, (1U << 30U) + 1, {}, memory) == Status::too_large);
  CHECK(Octree::workspace_bytes(0, {}) == 0);
  CHECK(Octree::prepare(octree, 10, {}, {}) == Status::workspace_too_small);
  CHECK(Octree::prepare(octree, 10, {}, std::span(memory).first(memory.size() / 2)) ==
        Status::workspace_too_small);
  CHECK(octree.build({}).status == Status::not_prepared);
  CHECK(Octree::prepare(octree, 10, {}, memory) == Status::ok);
}

TEST_CASE("an octree that is not prepared says so") {
  Octree octree;
  OctreeNeighbour neighbour;
  OctreeCrossing crossing;
  const test::Points points = {{0, 0, 0}};
  CHECK(octree.build(test::view(points)).status == Status::not_prepared);
  CHECK(octree.insert(test::view(points)).status == Status::not_prepared);
  CHECK(octree.nearest({}, neighbour).status == Status::not_prepared);
  CHECK(octree.k_nearest({}, {&neighbour, 1}).status == Status::not_prepared);
  CHECK(octree.radius({}, 1, {}).status == Status::not_prepared);
  CHECK(octree.box({}, {}).status == Status::not_prepared);
  CHECK(octree.ray({.direction = {1, 0, 0}}, {}).status == Status::not_prepared);
  CHECK(octree.first_hit({.direction = {1, 0, 0}}, crossing).status == Status::not_prepared);
  CHECK(octree.size() == 0);
}

TEST_CASE("views that make no sense add nothing") {
  test::Tree tree(4);
  const test::Points points = {{0, 0, 0}, {1, 1, 1}};
  REQUIRE(tree.octree.build(test::view(points)).status == Status::ok);
  PointsView view = test::view(points);
  view.y = nullptr;
  CHECK(tree.octree.insert(view).status == Status::invalid_image);
  view = test::view(points);
  view.stride = 5;
  CHECK(tree.octree.insert(view).status == Status::invalid_image);
  CHECK(tree.octree.size() == 2);
  CHECK(tree.octree.build(view).status == Status::invalid_image);
  CHECK(tree.octree.size() == 0);
}

TEST_CASE("queries refuse what is not a number, and take what is only large") {
  test::Tree tree(4);
  REQUIRE(tree.octree.build(test::view({{0, 0, 0}, {1, 1, 1}})).status == Status::ok);
  OctreeNeighbour out;
  for (const double bad : {not_a_number, infinite, -infinite, 1e101}) {
    for (const Vector3& at : {Vector3{bad, 0, 0}, Vector3{0, bad, 0}, Vector3{0, 0, bad}}) {
      CHECK(tree.octree.nearest(at, out).status == Status::invalid_option);
      CHECK(tree.octree.k_nearest(at, {&out, 1}).status == Status::invalid_option);
      CHECK(tree.octree.radius(at, 1, {&out, 1}).status == Status::invalid_option);
      CHECK(tree.octree.ray({.origin = at, .direction = {1, 0, 0}}, {}).status == Status::invalid_option);
    }
  }
  for (const double bad : {not_a_number, -1.0, -infinite}) {
    CHECK(tree.octree.nearest({}, out, bad).status == Status::invalid_option);
    CHECK(tree.octree.k_nearest({}, {&out, 1}, bad).status == Status::invalid_option);
    CHECK(tree.octree.radius({}, bad, {&out, 1}).status == Status::invalid_option);
    CHECK(tree.octree.ray({.direction = {1, 0, 0}, .max_distance_m = bad}, {}).status ==
          Status::invalid_option);
  }
  for (const Vector3& bad : {Vector3{}, Vector3{not_a_number, 0, 1}, Vector3{infinite, 0, 0}})
    CHECK(tree.octree.ray({.direction = bad}, {}).status == Status::invalid_option);
  CHECK(tree.octree.box({{0, 0, 0}, {-1, 1, 1}}, {}).status == Status::invalid_option);
  CHECK(tree.octree.box({{0, not_a_number, 0}, {1, 1, 1}}, {}).status == Status::invalid_option);

  REQUIRE(tree.octree.nearest({1e100, -1e100, 0}, out).found == 1);
  CHECK(out.squared_distance == 2e200);
  CHECK(tree.octree.radius({}, infinite, {}).found == 2);
  CHECK(tree.octree.box({{-infinite, -1, -1}, {infinite, 2, 2}}, {}).found == 2);
  OctreeCrossing crossing;
  CHECK(tree.octree.first_hit({.origin = {-5, 0, 0}, .direction = {1e300, 1e-300, 0}}, crossing).found == 1);
  CHECK(crossing.enter_m == Approx(5));
  CHECK(tree.octree.first_hit({.origin = {-5, 0, 0}, .direction = {1e-300, 0, 0}}, crossing).found == 1);
}

TEST_CASE("a full output holds what came first and counts the rest") {
  test::Tree tree(4);
  REQUIRE(tree.octree.build(test::view({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 0, 0}})).status == Status::ok);
  OctreeNeighbour near[2];
  std::uint32_t indices[2];
  OctreeCrossing crossings[2];
  OctreeFound found = tree.octree.radius({1, 0, 0}, 1, near);
  CHECK(found.status == Status::output_full);
  CHECK(found.found == 3);
  CHECK(found.written == 2);
  CHECK(near[1] == OctreeNeighbour{1, 0});
  found = tree.octree.box({{0, 0, 0}, {2, 0, 0}}, indices);
  CHECK(found.status == Status::output_full);
  CHECK(found.found == 3);
  CHECK(indices[1] == 1);
  found = tree.octree.ray({.origin = {20, 0.01, 0.01}, .direction = {-1, 0, 0}}, crossings);
  CHECK(found.status == Status::output_full);
  CHECK(found.found == 4);
  CHECK(tree.octree.point(tree.octree.nodes()[crossings[0].leaf].first).index == 3);
  CHECK(tree.octree.k_nearest({0, 0, 0}, near).found == 2);
  CHECK(tree.octree.k_nearest({0, 0, 0}, {}).found == 0);
}
