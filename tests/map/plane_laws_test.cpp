// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_scene.hpp"
#include "straightedge/host/plane_leaves_file.hpp"

using namespace straightedge;
using scene::Frame;

namespace {

std::vector<std::size_t> shuffled(std::size_t count, Pcg32& random) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  return order;
}

}  // namespace

TEST_CASE("any order of frames gives the same leaves and the same map") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 9, 40);
  PlaneMapBuilder in_order(scene::options());
  for (const Frame& frame : frames) scene::add(in_order, frame);
  const std::string bytes = plane_leaves_to_bytes(in_order.leaves());
  const PlaneMap map = scene::read(in_order).map;
  REQUIRE(map.planes.size() >= 6);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    PlaneMapBuilder builder(scene::options());
    for (const std::size_t i : shuffled(frames.size(), random)) scene::add(builder, frames[i]);
    CHECK(plane_leaves_to_bytes(builder.leaves()) == bytes);
    CHECK(scene::read(builder).map == map);
  }
}

TEST_CASE("any partition of frames over merged builders gives the same leaves and the same map") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 9, 50);
  PlaneMapBuilder at_once(scene::options());
  for (const Frame& frame : frames) scene::add(at_once, frame);
  const std::string bytes = plane_leaves_to_bytes(at_once.leaves());
  const PlaneMap map = scene::read(at_once).map;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    std::vector<PlaneMapBuilder> parts(4, PlaneMapBuilder(scene::options()));
    for (const Frame& frame : frames) scene::add(parts[random.below(4)], frame);
    PlaneMapBuilder whole(scene::options());
    for (const std::size_t i : shuffled(parts.size(), random)) REQUIRE(whole.merge(parts[i]));
    CHECK(plane_leaves_to_bytes(whole.leaves()) == bytes);
    CHECK(scene::read(whole).map == map);
  }
}

TEST_CASE("merging with an empty map and with oneself") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 3, 60);
  PlaneMapBuilder once(scene::options()), twice(scene::options());
  for (const Frame& frame : frames) scene::add(once, frame);
  for (int i = 0; i < 2; ++i) {
    for (const Frame& frame : frames) scene::add(twice, frame);
  }
  const std::string bytes = plane_leaves_to_bytes(once.leaves());
  REQUIRE(once.merge(PlaneMapBuilder(scene::options())));
  CHECK(plane_leaves_to_bytes(once.leaves()) == bytes);
  REQUIRE(once.merge(once));
  CHECK(plane_leaves_to_bytes(once.leaves()) == plane_leaves_to_bytes(twice.leaves()));
}

TEST_CASE("a refused frame leaves no trace") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 3, 70);
  PlaneMapBuilder builder(scene::options());
  scene::add(builder, frames[0]);
  const std::string bytes = plane_leaves_to_bytes(builder.leaves());
  Frame bad = frames[1];
  bad.pose.rotation[0] = 2;
  CHECK_FALSE(builder.add(bad.view(), bad.labels.view(), bad.planes, bad.pose));
  bad = frames[1];
  bad.planes.pop_back();
  CHECK_FALSE(builder.add(bad.view(), bad.labels.view(), bad.planes, bad.pose));
  CHECK(plane_leaves_to_bytes(builder.leaves()) == bytes);
}

TEST_CASE("the sums of a leaf are those of its readings, one by one") {
  // One frame, no noise: what lies in the leaves must be the frame's readings and nothing else.
  const Frame frame = scene::tour(scene::room(), 5, 80)[2];
  PlaneMapBuilder builder(scene::options());
  const RegisteredFrame registered = scene::add(builder, frame);
  std::uint64_t readings = 0;
  double x = 0, weight = 0;
  for (const PlaneLeaf& leaf : builder.leaves().unordered()) {
    readings += leaf.sums.readings;
    const MortonCell cell = morton_decode(leaf.key.leaf);
    const double centre = (static_cast<double>(cell.x) - (1 << 20) + 0.5) * plane_grid::leaf_m;
    x += static_cast<double>(leaf.sums.x) * plane_grid::quantum_m +
         static_cast<double>(leaf.sums.weight) * (centre + plane_grid::quantum_m / 2);
    weight += static_cast<double>(leaf.sums.weight);
    CHECK(leaf.sums.xx * leaf.sums.weight >= leaf.sums.x * leaf.sums.x);
  }
  CHECK(readings == registered.placed);
  double expected_x = 0, expected_weight = 0;
  std::uint64_t labelled = 0;
  for (std::int32_t v = 0; v < scene::frame_size.height; ++v) {
    for (std::int32_t u = 0; u < scene::frame_size.width; ++u) {
      const std::uint16_t label = frame.labels.view().at(u, v);
      if (label == 0) continue;
      ++labelled;
      const Plane& plane = frame.planes[label - 1U].fit.plane;
      const Vector3 ray = frame.camera.ray(u, v);
      const double z = plane.distance / dot(plane.normal, ray);
      const double w = 1 / (1.425e-3 * z * plane.distance) / (1.425e-3 * z * plane.distance) / 16;
      expected_x += std::min(w, 65536.0) * frame.pose.apply(z * ray).x;
      expected_weight += std::min(w, 65536.0);
    }
  }
  CHECK(labelled == registered.placed);
  CHECK(weight == Approx(expected_weight).epsilon(0.01));
  CHECK(x / weight == Approx(expected_x / expected_weight).margin(0.005));
}
