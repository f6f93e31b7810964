// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_scene.hpp"
#include "straightedge/host/plane_map_merge.hpp"

using namespace straightedge;
using scene::Frame;

namespace {

PlaneMap map_of(const std::vector<Frame>& frames, std::size_t first, std::size_t end) {
  PlaneMapBuilder builder(scene::options());
  for (std::size_t i = first; i < end; ++i) scene::add(builder, frames[i]);
  return scene::read(builder).map;
}

PlaneMap merged(const PlaneMap& a, const PlaneMap& b) {
  const auto result = merge_plane_maps(a, b, scene::options());
  if (!result) FAIL(result.failure().sentence);
  return *result;
}

}  // namespace

TEST_CASE("two halves of a tour merge into the map of the whole, within the noise") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 16, 90);
  const PlaneMap whole = map_of(frames, 0, 16);
  const PlaneMap both = merged(map_of(frames, 0, 8), map_of(frames, 8, 16));
  REQUIRE(both.planes.size() == whole.planes.size());
  for (std::size_t i = 0; i < whole.planes.size(); ++i) {
    const MapPlane& p = whole.planes[i];
    const MapPlane& q = both.planes[i];
    CAPTURE(i);
    CHECK(q.id == i + 1);
    CHECK(scene::angle_to(q, p.plane.normal) < 0.05 * degree);
    CHECK(std::abs(p.plane.signed_distance(q.moments->mean)) < 0.002);
    CHECK(static_cast<double>(*q.points) == Approx(static_cast<double>(*p.points)).epsilon(0.02));
    CHECK(scene::area(q) == Approx(scene::area(p)).epsilon(0.05));
    CHECK(q.seen == p.seen);
    for (const MapPolygon& polygon : q.polygons) {
      for (const Vector3& v : polygon.points) CHECK(std::abs(q.plane.signed_distance(v)) < 1e-9);
    }
  }
}

TEST_CASE("the order of two maps does not matter") {
  const std::vector<Frame> frames = scene::tour(scene::room(), 10, 91);
  const PlaneMap a = map_of(frames, 0, 5), b = map_of(frames, 5, 10);
  CHECK(merged(a, b) == merged(b, a));
}

TEST_CASE("merging with nothing changes nothing") {
  const PlaneMap map = map_of(scene::tour(scene::room(), 10, 92), 0, 10);
  CHECK(merged(map, PlaneMap{}).planes == map.planes);
  CHECK(merged(PlaneMap{}, PlaneMap{}).planes.empty());
}

TEST_CASE("planes near one another in different maps stay apart when they differ") {
  const auto wall = [](double y) {
    const std::vector<scene::Rectangle> one{{{-2, y, 0}, {4, 0, 0}, {0, 0, 2.5}, {}, 1}};
    return map_of({scene::seen(one, scene::look({0, 0, 1.2}, {0, 2, 1.2}), 8)}, 0, 1);
  };
  CHECK(merged(wall(2), wall(2.1)).planes.size() == 2);
  CHECK(merged(wall(2), wall(2.002)).planes.size() == 1);
}

TEST_CASE("planes that other programs wrote, without moments, merge by their corners") {
  PlaneMap map = map_of(scene::tour(scene::room(), 10, 93), 0, 10);
  PlaneMap bare = map;
  for (MapPlane& plane : bare.planes) {
    plane.moments.reset();
    plane.covariance.reset();
    plane.points.reset();
    plane.count.reset();
  }
  const PlaneMap both = merged(map, bare);
  REQUIRE(both.planes.size() == map.planes.size());
  for (std::size_t i = 0; i < map.planes.size(); ++i)
    CHECK(scene::angle_to(both.planes[i], map.planes[i].plane.normal) < 0.2 * degree);
}

TEST_CASE("maps with numbers that are none are refused") {
  PlaneMap map = map_of(scene::tour(scene::room(), 3, 94), 0, 3);
  map.planes[0].moments->mean.x = __builtin_nan("");
  CHECK(merge_plane_maps(map, PlaneMap{}).failure().problem == Problem::bad_content);
  PlaneMapOptions options;
  options.max_gap = -1;
  CHECK(merge_plane_maps(PlaneMap{}, PlaneMap{}, options).failure().problem == Problem::bad_option);
}
