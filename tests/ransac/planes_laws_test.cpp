// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>

#include "run_planes.hpp"

using namespace straightedge;

namespace {

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

scene::Cloud room_cloud(std::uint64_t seed) {
  Pcg32 random(seed);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.3, random);
  return scene::to_cloud(frame);
}

scene::Cloud readings_of(const scene::Cloud& cloud) {
  scene::Cloud readings;
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    if (!(cloud.z[i] > 0)) continue;
    readings.x.push_back(cloud.x[i]);
    readings.y.push_back(cloud.y[i]);
    readings.z.push_back(cloud.z[i]);
  }
  return readings;
}

RansacOptions several(double fixed_m) {
  RansacOptions options{.max_planes = 4, .seed = 17};
  options.gate.fixed_m = fixed_m;
  return options;
}

void check_same(const scene::FoundPlanes& a, const scene::FoundPlanes& b) {
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    CHECK(a.planes[i].fit.plane == b.planes[i].fit.plane);
    CHECK(a.planes[i].fit.covariance == b.planes[i].fit.covariance);
    CHECK(a.planes[i].inliers == b.planes[i].inliers);
    CHECK(a.planes[i].iterations == b.planes[i].iterations);
  }
}

}  // namespace

TEST_CASE("The same seed gives the same bits, another seed another search", "[ransac][laws]") {
  const scene::Cloud cloud = room_cloud(1);
  for (const double fixed : {0.0, 0.02}) {
    const scene::FoundPlanes a = scene::find(cloud.view(), several(fixed));
    const scene::FoundPlanes b = scene::find(cloud.view(), several(fixed));
    check_same(a, b);
    CHECK(a.labels == b.labels);
    RansacOptions other = several(fixed);
    other.seed = 18;
    CHECK_FALSE(scene::find(cloud.view(), other).planes[0].fit.plane == a.planes[0].fit.plane);
  }
}

TEST_CASE("Points that are no readings change nothing but the places of labels", "[ransac][laws]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const scene::Cloud all = room_cloud(seed);
    scene::Cloud dense, strewn;
    std::vector<std::size_t> place;
    Pcg32 random(seed);
    for (std::size_t i = 0; i < all.x.size(); ++i) {
      const bool reading = all.z[i] > 0;
      const auto add = [&](scene::Cloud& c, float x, float y, float z) {
        c.x.push_back(x);
        c.y.push_back(y);
        c.z.push_back(z);
      };
      if (!reading) continue;
      add(dense, all.x[i], all.y[i], all.z[i]);
      while (random.below(3) == 0) add(strewn, random.below(2) == 0 ? nan_f : 1, nan_f, 2);
      place.push_back(strewn.x.size());
      add(strewn, all.x[i], all.y[i], all.z[i]);
    }
    for (const double fixed : {0.0, 0.02}) {
      CAPTURE(seed, fixed);
      const scene::FoundPlanes a = scene::find(dense.view(), several(fixed));
      const scene::FoundPlanes b = scene::find(strewn.view(), several(fixed));
      check_same(a, b);
      CHECK(a.result.found.readings == b.result.found.readings);
      std::vector<std::uint16_t> moved;
      for (const std::size_t i : place) moved.push_back(b.labels[i]);
      CHECK(moved == a.labels);
    }
  }
}

TEST_CASE("One point alone that is no reading changes nothing, wherever it is", "[ransac][laws]") {
  const scene::Cloud dense = readings_of(room_cloud(6));
  const std::size_t count = dense.x.size();
  for (const double fixed : {0.0, 0.02}) {
    const scene::FoundPlanes a = scene::find(dense.view(), several(fixed));
    for (const std::size_t place : {std::size_t{0}, std::size_t{1}, count / 2, count - 1, count}) {
      CAPTURE(fixed, place);
      scene::Cloud holed = dense;
      const auto at = static_cast<std::ptrdiff_t>(place);
      holed.x.insert(holed.x.begin() + at, nan_f);
      holed.y.insert(holed.y.begin() + at, 1);
      holed.z.insert(holed.z.begin() + at, 2);
      scene::FoundPlanes b = scene::find(holed.view(), several(fixed));
      check_same(a, b);
      CHECK(b.result.found.readings == count);
      CHECK(b.result.found.iterations == a.result.found.iterations);
      CHECK(b.labels[place] == 0);
      b.labels.erase(b.labels.begin() + at);
      CHECK(b.labels == a.labels);
    }
  }
}

TEST_CASE("Watching the search of a cloud with holes changes nothing, and shows each hypothesis once",
          "[ransac][laws]") {
  scene::Cloud cloud = readings_of(room_cloud(7));
  cloud.x[cloud.x.size() / 3] = nan_f;
  for (const double fixed : {0.0, 0.02}) {
    std::uint32_t events = 0;
    RansacOptions watched = several(fixed);
    watched.trace.user = &events;
    watched.trace.event = [](void* user, const RansacEvent&) {
      ++*static_cast<std::uint32_t*>(user);
      return true;
    };
    const scene::FoundPlanes a = scene::find(cloud.view(), several(fixed));
    const scene::FoundPlanes b = scene::find(cloud.view(), watched);
    check_same(a, b);
    CHECK(events == b.result.found.iterations);
  }
}

TEST_CASE("Arrays of structs and structs of arrays give the same planes", "[ransac][laws]") {
  const scene::Cloud cloud = room_cloud(3);
  struct Point {
    float intensity, x, y, z, more[2];
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < cloud.x.size(); ++i)
    points.push_back({0, cloud.x[i], cloud.y[i], cloud.z[i], {1, 2}});
  const PointsView view{&points[0].x, &points[0].y, &points[0].z, points.size(), sizeof(Point)};
  for (const double fixed : {0.0, 0.02}) {
    const scene::FoundPlanes a = scene::find(cloud.view(), several(fixed));
    const scene::FoundPlanes b = scene::find(view, several(fixed));
    check_same(a, b);
    CHECK(a.labels == b.labels);
  }
}

TEST_CASE("A cloud a kilometre away gives the planes of the cloud nearby", "[ransac][laws]") {
  // Coordinates in multiples of 2^-10 m keep every bit there.
  scene::Cloud near, far;
  scene::add_square(near, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, 33, 1);
  scene::add_square(near, {1, 0, 2}, {0, 1, 0}, {0, 0, 1}, 33, 1);
  for (std::size_t i = 0; i < near.x.size(); ++i) {
    far.x.push_back(near.x[i] + 1024);
    far.y.push_back(near.y[i] - 1024);
    far.z.push_back(near.z[i] + 1024);
  }
  const scene::FoundPlanes a = scene::find(near.view(), several(0.01));
  const scene::FoundPlanes b = scene::find(far.view(), several(0.01));
  REQUIRE(a.planes.size() == 2);
  REQUIRE(b.planes.size() == 2);
  CHECK(a.labels == b.labels);
  for (std::size_t i = 0; i < 2; ++i) {
    const Plane& p = a.planes[i].fit.plane;
    const Plane shifted = canonical({p.normal, p.distance + dot(p.normal, {1024, -1024, 1024})});
    CHECK(scene::error_of(b.planes[i].fit.plane, shifted).angle < 1e-6);
    CHECK(scene::error_of(b.planes[i].fit.plane, shifted).offset < 1e-4);
  }
}

TEST_CASE("A frame's stride changes no bit", "[ransac][laws]") {
  Pcg32 random(8);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.3, random);
  const RansacOptions options = several(0);
  const scene::FoundPlanes a = scene::find(frame, options);
  constexpr std::int32_t wide = scene::size.width + 5;
  std::vector<float> q(static_cast<std::size_t>(wide * scene::size.height), 0.7F);
  std::vector<std::uint16_t> labels(q.size(), 7);
  const ImageView<float> view(q.data(), scene::size, wide * static_cast<std::ptrdiff_t>(sizeof(float)));
  const ImageView<std::uint16_t> label_view(labels.data(), scene::size, wide * std::ptrdiff_t{2});
  for (std::int32_t v = 0; v < scene::size.height; ++v)
    for (std::int32_t u = 0; u < scene::size.width; ++u) view.at(u, v) = frame.view().at(u, v);
  std::vector<std::byte> workspace;
  RansacPlanes object = scene::prepared(frame.q.size(), options, workspace);
  scene::FoundPlanes b;
  b.planes.resize(8);
  b.result = object.run(view, scene::camera, b.planes, label_view);
  b.planes.resize(b.result.found.planes);
  check_same(a, b);
  for (std::int32_t v = 0; v < scene::size.height; ++v) {
    for (std::int32_t u = 0; u < scene::size.width; ++u)
      REQUIRE(label_view.at(u, v) == a.labels[static_cast<std::size_t>(v * scene::size.width + u)]);
    REQUIRE(labels[static_cast<std::size_t>(v * wide + scene::size.width)] == 7);
  }
}
