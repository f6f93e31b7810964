// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <set>

#include "run_planes.hpp"
#include "straightedge/ransac_stop.hpp"

using namespace straightedge;
using scene::add_square;

namespace {

constexpr RansacOptions all_planes{.max_planes = 8, .min_share = 0.03};

/// How many of the room's large planes are among those found, and well enough.
int found_of(const scene::Room& room, const scene::Frame& frame, const std::vector<FoundPlane>& planes,
             int& asked) {
  int good = 0, label = 0;
  const auto look = [&](const Plane& truth) {
    if (frame.pixels_of(++label) < frame.q.size() / 20) return;
    ++asked;
    for (const FoundPlane& plane : planes) {
      const scene::PlaneError e = scene::error_of(plane.fit.plane, truth);
      if (e.angle > 0.02 || e.offset > 0.02) continue;
      ++good;
      return;
    }
  };
  for (const Plane& plane : room.planes) look(plane);
  for (const scene::Face& face : room.faces) look(face.plane);
  return good;
}

}  // namespace

TEST_CASE("Frames and clouds give the planes of the room, with 60 % holes too", "[ransac]") {
  for (const double holes : {0.0, 0.6}) {
    int asked_frame = 0, asked_cloud = 0, frame_good = 0, cloud_good = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      CAPTURE(seed, holes);
      Pcg32 random(seed);
      const scene::Room room = scene::room_by_chance(random);
      const scene::Frame frame = scene::render(room, scene::sigma, holes, random);
      RansacOptions options = all_planes;
      options.seed = seed;
      const scene::FoundPlanes a = scene::find(frame, options);
      const scene::Cloud cloud = scene::to_cloud(frame);
      const scene::FoundPlanes b = scene::find(cloud.view(), options);
      REQUIRE(a.result.status == Status::ok);
      REQUIRE(b.result.status == Status::ok);
      CHECK(a.result.found.readings == b.result.found.readings);
      CHECK(a.result.found.seed == seed);
      frame_good += found_of(room, frame, a.planes, asked_frame);
      cloud_good += found_of(room, frame, b.planes, asked_cloud);
    }
    CAPTURE(holes, frame_good, cloud_good);
    CHECK(frame_good * 20 >= asked_frame * 19);
    CHECK(cloud_good * 20 >= asked_cloud * 19);
  }
}

TEST_CASE("Close to the camera the gate is the floor in metres, for frames and clouds", "[ransac]") {
  // A wall at 0.4 m, every other pixel 3 mm nearer or farther: far beyond the noise of 1/z, within the floor.
  scene::Frame wall;
  for (std::int32_t i = 0; i < scene::size.width * scene::size.height; ++i) {
    wall.q.push_back(static_cast<float>(1 / (0.4 + (i % 2 == 0 ? 0.003 : -0.003))));
  }
  const scene::Cloud cloud = scene::to_cloud(wall);
  RansacOptions options;
  options.max_planes = 1;
  CHECK(scene::find(wall, options).result.found.labelled == wall.q.size());
  CHECK(scene::find(cloud.view(), options).result.found.labelled == wall.q.size());
  options.gate.floor_m = 0;
  CHECK(scene::find(wall, options).result.found.labelled < wall.q.size() * 3 / 4);
  CHECK(scene::find(cloud.view(), options).result.found.labelled < wall.q.size() * 3 / 4);
}

TEST_CASE("Counts, labels and figures of the result agree", "[ransac]") {
  Pcg32 random(21);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.2, random);
  const scene::FoundPlanes found = scene::find(frame, all_planes);
  REQUIRE(found.planes.size() >= 3);
  std::uint32_t labelled = 0, iterations = 0;
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    const FoundPlane& plane = found.planes[i];
    std::uint32_t own = 0;
    for (std::size_t k = 0; k < frame.q.size(); ++k) {
      if (found.labels[k] != i + 1) continue;
      ++own;
      CHECK(frame.q[k] > 0);
    }
    CHECK(own == plane.inliers);
    CHECK(plane.fit.rms > 0);
    CHECK(plane.fit.covariance[0] > 0);
    CHECK(plane.confidence >= 0.999);
    labelled += own;
    iterations += plane.iterations;
  }
  CHECK(labelled == found.result.found.labelled);
  CHECK(iterations <= found.result.found.iterations);
}

TEST_CASE("The first plane is the plane with the most readings", "[ransac]") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    scene::Cloud cloud;
    add_square(cloud, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, 50, 1);
    add_square(cloud, {1, 0, 2}, {0, 1, 0}, {0, 0, 1}, 40, 0.9);
    add_square(cloud, {0, 1, 2}, {1, 0, 0}, {0, 0, 1}, 30, 0.9);
    RansacOptions options{.seed = seed};
    options.gate.fixed_m = 0.01;
    const scene::FoundPlanes found = scene::find(cloud.view(), options);
    REQUIRE(found.planes.size() == 1);
    CHECK(scene::error_of(found.planes[0].fit.plane, {{0, 0, 1}, 3}).angle < 1e-3);
    CHECK(found.planes[0].inliers >= 2500);
  }
}

TEST_CASE("Near sampling finds a small plane in clutter with few hypotheses", "[ransac]") {
  scene::Cloud cloud;
  Pcg32 random(2);
  for (int i = 0; i < 3000; ++i) {
    cloud.x.push_back(static_cast<float>(random.below(4000)) / 1000.0F);
    cloud.y.push_back(static_cast<float>(random.below(4000)) / 1000.0F);
    cloud.z.push_back(static_cast<float>(random.below(4000)) / 1000.0F);
  }
  add_square(cloud, {2, 2, 2}, {1, 0, 0}, {0, 1, 0}, 20, 0.15);
  RansacOptions options{.near_radius = 0.2};
  options.gate.fixed_m = 0.005;
  const scene::FoundPlanes near = scene::find(cloud.view(), options);
  options.near_radius = 0;
  const scene::FoundPlanes whole = scene::find(cloud.view(), options);
  REQUIRE(near.planes.size() == 1);
  CHECK(scene::error_of(near.planes[0].fit.plane, {{0, 0, 1}, 2}).angle < 0.02);
  CHECK(near.planes[0].confidence >= 0.999);
  CHECK(near.result.found.iterations * 10 < whole.result.found.iterations);
}

TEST_CASE("Splitting parts what is not connected and drops small pieces", "[ransac]") {
  scene::Cloud cloud;
  add_square(cloud, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, 40, 0.5);
  add_square(cloud, {3, 0, 3}, {1, 0, 0}, {0, 1, 0}, 30, 0.5);
  add_square(cloud, {0, 3, 3}, {1, 0, 0}, {0, 1, 0}, 8, 0.1);
  RansacOptions options{.max_planes = 3, .min_inliers = 100, .min_share = 0, .seed = 4};
  options.gate.fixed_m = 0.01;
  CHECK(scene::find(cloud.view(), options).planes.size() == 1);
  options.split = true;
  const scene::FoundPlanes found = scene::find(cloud.view(), options);
  REQUIRE(found.planes.size() == 2);
  CHECK(found.planes[0].inliers == 1600);
  CHECK(found.planes[1].inliers == 900);
  CHECK(found.labels[0] == 1);
  CHECK(found.labels[1600] == 2);
  CHECK(found.labels[2500] == 0);
  CHECK(found.result.found.labelled == 2500);
  // No room for the second piece.
  const scene::FoundPlanes one = scene::find(cloud.view(), options, 1);
  CHECK(one.result.status == Status::output_full);
  CHECK(one.labels[1600] == 0);
  // All pieces are too small.
  options.min_inliers = 1700;
  CHECK(scene::find(cloud.view(), options).planes.empty());
}

TEST_CASE("Pixels that touch are one piece", "[ransac]") {
  scene::Frame frame;
  frame.q.assign(320 * 240, 0.0F);
  const auto fill = [&](int u0, int v0, int u1, int v1) {
    for (int v = v0; v < v1; ++v)
      for (int u = u0; u < u1; ++u) frame.q[static_cast<std::size_t>(v * 320 + u)] = 0.5F;
  };
  fill(10, 10, 60, 60);
  fill(60, 60, 100, 100);  // touches the first at a corner
  fill(200, 100, 260, 150);
  RansacOptions options{.min_share = 0, .split = true};
  const scene::FoundPlanes found = scene::find(frame, options);
  REQUIRE(found.planes.size() == 2);
  CHECK(found.planes[0].inliers == 2500 + 1600);
  CHECK(found.planes[1].inliers == 3000);
}

TEST_CASE("The trace tells every hypothesis and can stop the search", "[ransac]") {
  Pcg32 random(6);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.2, random);
  struct Seen {
    std::uint32_t events = 0, limit = 0;
    float best = 1e9F;
    bool sound = true;
  } seen;
  RansacOptions options;
  options.trace.user = &seen;
  options.trace.event = [](void* user, const RansacEvent& e) {
    Seen& s = *static_cast<Seen*>(user);
    const std::set<std::uint32_t> three(e.triple, e.triple + 3);
    s.sound =
        s.sound && three.size() == 3 && e.iteration >= s.events && (e.inliers > 0) == e.best && e.cost >= 0;
    if (e.best) {
      s.sound = s.sound && e.cost < s.best;
      s.best = e.cost;
    }
    return ++s.events != s.limit;
  };
  const scene::FoundPlanes all = scene::find(frame, options);
  CHECK(seen.sound);
  CHECK(seen.events == all.result.found.iterations);
  seen = {.limit = 5};
  CHECK(scene::find(frame, options).result.status == Status::cancelled);
  CHECK(seen.events == 5);
}
