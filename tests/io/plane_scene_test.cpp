// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_scene.hpp"

#include <cstdlib>
#include <limits>

#include "catch.hpp"
#include "room_plane_map.hpp"

using namespace straightedge;
using namespace straightedge::io;

namespace {

MapPolygon square(double x, double y, double side, bool hole) {
  MapPolygon polygon{hole, {{x, y, 1}, {x + side, y, 1}, {x + side, y + side, 1}, {x, y + side, 1}}};
  if (hole) std::ranges::reverse(polygon.points);
  return polygon;
}

PlaneMap nested_map() {
  PlaneMap map;
  MapPlane plane;
  plane.id = 1;
  plane.plane = {{0, 0, 1}, 1};
  plane.polygons = {square(0, 0, 10, false), square(2, 2, 4, false), square(1, 1, 6, true),
                    square(3, 3, 1, true),   square(20, 0, 1, true), square(30, 0, 2, false)};
  map.planes.push_back(plane);
  return map;
}

/// Every coordinate through the same change of axes.
template <class Change>
PlaneMap changed(PlaneMap map, Change&& change) {
  for (MapPlane& plane : map.planes) {
    for (MapPolygon& polygon : plane.polygons) {
      for (Vector3& p : polygon.points) p = change(p);
    }
  }
  return map;
}

UpAxis found_up(const PlaneMap& map, std::span<const Pose> path = {}) {
  return plane_scene(map, UpAxis::automatic, path).up;
}

}  // namespace

TEST_CASE("a hole belongs to the smallest border round it; one round which there is none is left out") {
  const PlaneMap map = nested_map();
  const PlaneScene scene = plane_scene(map, UpAxis::z, {});
  REQUIRE(scene.pieces.size() == 3);
  CHECK(scene.pieces[0].rings.size() == 2);
  CHECK(scene.pieces[0].area == Approx(100 - 36));
  CHECK(scene.pieces[1].rings.size() == 2);
  CHECK(scene.pieces[1].area == Approx(16 - 1));
  CHECK(scene.pieces[2].rings.size() == 1);
  CHECK(scene.planes[0].area == Approx(64 + 15 + 4));
  CHECK(scene.planes[0].length == Approx(32));
  CHECK(scene.planes[0].width == Approx(10));
  CHECK(scene.low == Vector3{0, 0, 1});
  CHECK(scene.high == Vector3{32, 10, 1});
  for (const ScenePiece& piece : scene.pieces) CHECK(piece.anchor.z == Approx(1));
}

TEST_CASE("what cannot be drawn is left out, its plane stays") {
  PlaneMap map = nested_map();
  map.planes[0].polygons[0].points[2].x = std::numeric_limits<double>::quiet_NaN();
  map.planes[0].polygons[1].points.resize(2);
  map.planes[0].polygons[5].points[0].y = 1e10;
  map.planes.emplace_back();
  map.planes.back().plane.normal = {0, 0, 0};
  map.planes.back().polygons = {square(0, 0, 1, false)};
  const PlaneScene scene = plane_scene(map, UpAxis::automatic, {});
  CHECK(scene.pieces.empty());
  CHECK(scene.planes.size() == 2);
  CHECK(scene.up == UpAxis::z);
}

TEST_CASE("the front of a plane is the side it was seen from, else the side of nearly all others") {
  PlaneMap map = room_plane_map();
  map.planes[0].seen = SeenSide::both;
  std::vector<int> fronts;
  for (const ScenePlane& plane : plane_scene(map, UpAxis::z, {}).planes) fronts.push_back(plane.front);
  CHECK(fronts[0] == 0);
  CHECK(fronts[1] == -1);  // ceiling, normal up
  CHECK(fronts[3] == 1);   // wall at x = 0, normal into the room
  for (MapPlane& plane : map.planes) plane.seen = SeenSide::unknown;
  const PlaneScene guessed = plane_scene(map, UpAxis::z, {});
  CHECK(guessed.planes[0].front == 1);   // floor
  CHECK(guessed.planes[1].front == -1);  // ceiling
  CHECK(guessed.planes[3].front == 1);   // wall at x = 0
  CHECK(guessed.planes[5].front == -1);  // wall at x = w
  CHECK(guessed.planes[6].front == 0);   // table
}

TEST_CASE("the cameras tell which axis is up, without them the map does") {
  const PlaneMap room = room_plane_map();
  CHECK(found_up(room) == UpAxis::z);
  CHECK(found_up({}) == UpAxis::z);
  const PlaneMap before_camera = changed(room, [](const Vector3& p) {
    return Vector3{p.x - 2.6, 1.3 - p.z, p.y + 3};
  });
  CHECK(found_up(before_camera) == UpAxis::minus_y);
  const PlaneMap beside_camera = changed(room, [](const Vector3& p) {
    return Vector3{p.x + 2.6, 1.3 - p.z, p.y + 3};
  });
  CHECK(found_up(beside_camera) == UpAxis::z);

  CHECK(found_up(before_camera, room_camera_path(7)) == UpAxis::z);
  CHECK(found_up(room, std::vector<Pose>(3)) == UpAxis::minus_y);
  Pose head_over;
  head_over.rotation = {1, 0, 0, 0, -1, 0, 0, 0, -1};
  CHECK(found_up(room, std::vector<Pose>{head_over}) == UpAxis::y);
  CHECK(plane_scene(room, UpAxis::y, room_camera_path(7)).up == UpAxis::y);
}

TEST_CASE("an oblique view is from the corner to which most fronts are turned") {
  PlaneMap room = room_plane_map();
  CHECK(oblique_turn(plane_scene(room, UpAxis::z, {})) == -60);
  CHECK(oblique_turn(plane_scene({}, UpAxis::z, {})) == -60);
  const MapPlane floor = room.planes[0], near_wall = room.planes[4], left_wall = room.planes[3];
  room.planes = {floor, near_wall};  // seen from inside, so its front looks back
  CHECK(std::abs(oblique_turn(plane_scene(room, UpAxis::z, {})) - 75) == 45);
  room.planes = {floor, near_wall, left_wall};
  CHECK(oblique_turn(plane_scene(room, UpAxis::z, {})) == 30);
}

TEST_CASE("upright coordinates are right-handed") {
  for (const UpAxis up : {UpAxis::z, UpAxis::y, UpAxis::minus_y}) {
    const Vector3 x = upright({1, 0, 0}, up), y = upright({0, 1, 0}, up), z = upright({0, 0, 1}, up);
    CHECK(cross(x, y) == z);
  }
  CHECK(upright({0, 1, 0}, UpAxis::y) == Vector3{0, 0, 1});
  CHECK(upright({0, -1, 0}, UpAxis::minus_y) == Vector3{0, 0, 1});
}
