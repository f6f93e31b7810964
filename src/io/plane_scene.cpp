// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_scene.hpp"

#include <algorithm>
#include <cmath>

#include "io/plane_rings.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {
namespace {

bool drawable_border(const MapPolygon& polygon) {
  return polygon.points.size() >= 3 && std::ranges::all_of(polygon.points, drawable);
}

Ring flattened(const std::vector<Vector3>& points, const PlaneBasis& basis) {
  Ring ring;
  ring.reserve(points.size());
  for (const Vector3& p : points) ring.push_back(basis.flat(p));
  return ring;
}

/// A piece and its rings on the plane.
struct FlatPiece {
  ScenePiece piece;
  std::vector<Ring> rings;
};

std::vector<FlatPiece> outer_borders(const MapPlane& plane, std::size_t index, const PlaneBasis& basis) {
  std::vector<FlatPiece> pieces;
  for (const MapPolygon& polygon : plane.polygons) {
    if (polygon.hole || !drawable_border(polygon)) continue;
    FlatPiece piece;
    piece.piece.plane = index;
    piece.piece.rings.push_back(polygon.points);
    piece.rings.push_back(flattened(polygon.points, basis));
    piece.piece.area = std::abs(signed_area(piece.rings.front()));
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void add_holes(const MapPlane& plane, const PlaneBasis& basis, std::vector<FlatPiece>& pieces) {
  std::vector<double> outer_area;
  for (const FlatPiece& piece : pieces) outer_area.push_back(piece.piece.area);
  for (const MapPolygon& polygon : plane.polygons) {
    if (!polygon.hole || !drawable_border(polygon)) continue;
    const Ring hole = flattened(polygon.points, basis);
    std::size_t owner = pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const bool smaller = owner == pieces.size() || outer_area[i] < outer_area[owner];
      if (smaller && inside(hole.front(), {pieces[i].rings.front()})) owner = i;
    }
    if (owner == pieces.size()) continue;
    pieces[owner].piece.rings.push_back(polygon.points);
    pieces[owner].piece.area = std::max(0.0, pieces[owner].piece.area - std::abs(signed_area(hole)));
    pieces[owner].rings.push_back(hole);
  }
}

/// Steps 1 and 2 for one plane.
void add_plane(const MapPlane& map_plane, PlaneScene& scene) {
  constexpr double not_unit = 1e-3;
  ScenePlane plane;
  plane.plane = &map_plane;
  const PlaneBasis basis(map_plane.plane.normal);
  const Vector3 foot = map_plane.plane.distance * map_plane.plane.normal;
  const auto lifted = [&](Point2 p) { return foot + p.x * basis.u + p.y * basis.v; };
  std::vector<FlatPiece> pieces;
  if (drawable(foot) && std::abs(squared_length(map_plane.plane.normal) - 1) < not_unit) {
    pieces = outer_borders(map_plane, scene.planes.size(), basis);
    add_holes(map_plane, basis, pieces);
  }
  std::vector<Ring> outer;
  for (FlatPiece& flat : pieces) {
    flat.piece.middle = lifted(centroid(flat.rings.front()));
    flat.piece.anchor = lifted(label_place(flat.rings));
    plane.area += flat.piece.area;
    outer.push_back(std::move(flat.rings.front()));
    scene.pieces.push_back(std::move(flat.piece));
  }
  const Point2 sides = smallest_rectangle(outer);
  plane.length = sides.x;
  plane.width = sides.y;
  scene.planes.push_back(plane);
}

/// The side on which nearly all other area lies; 0 when there is none.
int crowded_side(const PlaneScene& scene, std::size_t index) {
  constexpr double nearly_all = 0.9;
  const Plane& plane = scene.planes[index].plane->plane;
  double plus = 0, minus = 0;
  for (const ScenePiece& piece : scene.pieces) {
    if (piece.plane == index) continue;
    (plane.signed_distance(piece.middle) > 0 ? plus : minus) += piece.area;
  }
  if (plus > nearly_all * (plus + minus)) return 1;
  return minus > nearly_all * (plus + minus) ? -1 : 0;
}

int front_side(const PlaneScene& scene, std::size_t index) {
  switch (scene.planes[index].plane->seen) {
    case SeenSide::plus:
      return 1;
    case SeenSide::minus:
      return -1;
    case SeenSide::both:
      return 0;
    default:
      return crowded_side(scene, index);
  }
}

void find_box(PlaneScene& scene) {
  bool first = true;
  for (const ScenePiece& piece : scene.pieces) {
    for (const Vector3& p : piece.rings.front()) {
      if (first) scene.low = scene.high = p;
      first = false;
      scene.low = {std::min(scene.low.x, p.x), std::min(scene.low.y, p.y), std::min(scene.low.z, p.z)};
      scene.high = {std::max(scene.high.x, p.x), std::max(scene.high.y, p.y), std::max(scene.high.z, p.z)};
    }
  }
}

UpAxis up_of_cameras(std::span<const Pose> path) {
  Vector3 up;
  for (const Pose& pose : path) {
    const Vector3 one = -pose.turned({0, 1, 0});
    if (finite(one)) up = up + one;
  }
  if (up.z >= up.y && up.z >= -up.y) return UpAxis::z;
  return up.y > 0 ? UpAxis::y : UpAxis::minus_y;
}

bool before_a_camera(const PlaneScene& scene) {
  constexpr double slope = 1.2;
  for (const ScenePiece& piece : scene.pieces) {
    for (const Vector3& p : piece.rings.front()) {
      if (!(p.z > 0) || std::abs(p.x) > slope * p.z || std::abs(p.y) > slope * p.z) return false;
    }
  }
  return !scene.pieces.empty();
}

}  // namespace

PlaneScene plane_scene(const PlaneMap& map, UpAxis up, std::span<const Pose> camera_path) {
  PlaneScene scene;
  // Steps 1 and 2
  for (const MapPlane& plane : map.planes) add_plane(plane, scene);
  find_box(scene);
  // Step 3
  for (std::size_t i = 0; i < scene.planes.size(); ++i) scene.planes[i].front = front_side(scene, i);
  // Step 4
  scene.up = up;
  if (up == UpAxis::automatic) {
    scene.up = !camera_path.empty()     ? up_of_cameras(camera_path)
               : before_a_camera(scene) ? UpAxis::minus_y
                                        : UpAxis::z;
  }
  return scene;
}

int oblique_turn(const PlaneScene& scene) {
  constexpr int first = -60;
  constexpr double clearly = 1.5;  // a door or a cupboard shall not decide
  int best = first;
  double most = 0;
  for (const int turn : {first, first + 90, first + 180, first - 90}) {
    const SineCosine way = sine_cosine(turn * degree);
    double shown = 0;
    for (const ScenePlane& plane : scene.planes) {
      if (!(plane.area > 0)) continue;
      const Vector3 normal = upright(plane.plane->plane.normal, scene.up);
      shown += plane.area * std::max(0.0, plane.front * (way.cosine * normal.x + way.sine * normal.y));
    }
    if (shown > clearly * most) {
      most = shown;
      best = turn;
    }
  }
  return best;
}

}  // namespace straightedge::io
