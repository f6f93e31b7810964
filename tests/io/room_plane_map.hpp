// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/pose.hpp"

/// A furnished room of 5.2 x 4.1 x 2.6 m, z up, made by hand: floor and ceiling, four walls (a door in one, a
/// window in another), a table, a cupboard, two boxes, a leaning board, and one plane without a border.
class RoomMaker {
 public:
  using Points = std::vector<straightedge::Vector3>;

  /// The plane through a border, seen from the side of `eye`.
  straightedge::MapPlane& add(const Points& border, const straightedge::Vector3& eye) {
    using namespace straightedge;
    Vector3 area;
    for (std::size_t i = 0; i < border.size(); ++i)
      area = area + cross(border[i], border[(i + 1) % border.size()]);
    const Vector3 normal = normalized(area);
    MapPlane plane;
    plane.id = static_cast<std::uint32_t>(map_.planes.size() + 1);
    plane.plane = canonical({normal, dot(normal, border[0])});
    plane.seen = plane.plane.signed_distance(eye) > 0 ? SeenSide::plus : SeenSide::minus;
    plane.points = static_cast<std::uint64_t>(4000 * length(area));
    plane.count = 3 + plane.id % 8;
    plane.source = "ransac";
    plane.polygons.push_back({false, border});
    if (dot(normal, plane.plane.normal) < 0) std::ranges::reverse(plane.polygons.back().points);
    map_.planes.push_back(plane);
    return map_.planes.back();
  }

  void add_hole(straightedge::MapPlane& plane, Points border) const {
    using namespace straightedge;
    Vector3 area;
    for (std::size_t i = 0; i < border.size(); ++i)
      area = area + cross(border[i], border[(i + 1) % border.size()]);
    if (dot(area, plane.plane.normal) > 0) std::ranges::reverse(border);
    plane.polygons.push_back({true, border});
  }

  /// Top and four sides of a box that stands at (x, y), turned by an angle given as cosine and sine.
  void add_box(double x, double y, double z, double w, double d, double h, double c, double s) {
    const auto at = [&](double u, double v, double up) {
      return straightedge::Vector3{x + c * u - s * v, y + s * u + c * v, z + up};
    };
    const straightedge::Vector3 above{x, y, z + h + 10};
    add({at(0, 0, h), at(w, 0, h), at(w, d, h), at(0, d, h)}, above);
    add({at(0, 0, 0), at(w, 0, 0), at(w, 0, h), at(0, 0, h)}, at(w / 2, -10, 0));
    add({at(w, 0, 0), at(w, d, 0), at(w, d, h), at(w, 0, h)}, at(w + 10, d / 2, 0));
    add({at(w, d, 0), at(0, d, 0), at(0, d, h), at(w, d, h)}, at(w / 2, d + 10, 0));
    add({at(0, d, 0), at(0, 0, 0), at(0, 0, h), at(0, d, h)}, at(-10, d / 2, 0));
  }

  straightedge::PlaneMap take() { return std::move(map_); }

 private:
  straightedge::PlaneMap map_;
};

inline straightedge::PlaneMap room_plane_map() {
  using straightedge::MapPlane;
  const double w = 5.2, d = 4.1, h = 2.6;
  const straightedge::Vector3 middle{2.6, 2, 1.3};
  RoomMaker room;
  room.add({{0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0}}, middle);
  room.add({{0, 0, h}, {w, 0, h}, {w, d, h}, {0, d, h}}, middle);
  room.add({{0, d, 0}, {1.2, d, 0}, {1.2, d, 2}, {2.1, d, 2}, {2.1, d, 0}, {w, d, 0}, {w, d, h}, {0, d, h}},
           middle);
  MapPlane& window = room.add({{0, 0, 0}, {0, d, 0}, {0, d, h}, {0, 0, h}}, middle);
  room.add_hole(window, {{0, 1, 0.9}, {0, 3, 0.9}, {0, 3, 2.1}, {0, 1, 2.1}});
  room.add({{0, 0, 0}, {w, 0, 0}, {w, 0, h}, {0, 0, h}}, middle);
  room.add({{w, 0, 0}, {w, d, 0}, {w, d, h}, {w, 0, h}}, middle);
  room.add({{2.2, 1.2, 0.74}, {3.8, 1.2, 0.74}, {3.8, 2.0, 0.74}, {2.2, 2.0, 0.74}}, {3, 1.5, 2});  // table
  room.add_box(2.5, 1.4, 0.74, 0.35, 0.25, 0.22, 0.9, 0.436);                                       // on it
  room.add_box(4.5, 2.4, 0, 0.65, 1.4, 1.9, 1, 0);  // cupboard
  room.add_box(0.9, 2.6, 0, 0.6, 0.5, 0.45, 0.8, 0.6);
  room.add({{2.6, 4.08, 0.95}, {3.6, 4.08, 0.95}, {3.6, 3.6, 0}, {2.6, 3.6, 0}}, middle);  // board
  straightedge::PlaneMap map = room.take();
  MapPlane bare;
  bare.id = 40;
  bare.plane = {{0, 0, 1}, 1.1};
  map.planes.push_back(bare);
  map.meta.name = "A room";
  map.meta.tool = "straightedge 0.3.0";
  map.meta.options = "--method ransac --seed 1";
  return map;
}

/// A camera that goes round the middle of the room and looks outward, a little downward.
inline std::vector<straightedge::Pose> room_camera_path(int count) {
  using straightedge::Vector3;
  std::vector<straightedge::Pose> path;
  for (int i = 0; i < count; ++i) {
    const double a = 6.283185307179586 * i / count;
    const Vector3 forward = straightedge::normalized({std::cos(a), std::sin(a), -0.2});
    const Vector3 right = straightedge::normalized(straightedge::cross(forward, {0, 0, 1}));
    const Vector3 down = straightedge::cross(forward, right);
    straightedge::Pose pose;
    pose.rotation = {right.x, down.x, forward.x, right.y, down.y, forward.y, right.z, down.z, forward.z};
    pose.translation = {2.6 + 0.9 * std::cos(a), 2.2 + 0.7 * std::sin(a), 1.4};
    path.push_back(pose);
  }
  return path;
}
