// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "straightedge/host/label_picture.hpp"
#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/plane_view.hpp"
#include "straightedge/host/pose.hpp"

namespace straightedge::io {

/// Finite, and not so far away that pictures run out of digits.
constexpr bool drawable(const Vector3& p) noexcept {
  constexpr double limit = 1e9;  // metres
  return p.x < limit && p.x > -limit && p.y < limit && p.y > -limit && p.z < limit && p.z > -limit;
}

/// One outer border with the holes in it.
struct ScenePiece {
  std::size_t plane = 0;                    ///< index into the scene's planes
  std::vector<std::vector<Vector3>> rings;  ///< the outer border first
  double area = 0;                          ///< m², holes off
  Vector3 middle;                           ///< centroid of the outer border
  Vector3 anchor;                           ///< a place within for the id, away from borders
};

struct ScenePlane {
  const MapPlane* plane = nullptr;
  double area = 0;               ///< m²
  double length = 0, width = 0;  ///< m: of the smallest rectangle round all pieces, by whole degrees
  int front = 0;                 ///< the side one looks at: +1 that of the normal, −1 the other, 0 both
};

/// A plane map as its pictures need it. Refers to the map.
struct PlaneScene {
  UpAxis up = UpAxis::z;           ///< never automatic
  std::vector<ScenePlane> planes;  ///< in the map's order
  std::vector<ScenePiece> pieces;  ///< in the order of planes and polygons
  Vector3 low, high;               ///< box round all pieces; zero without any
};

/// Steps:
///  1. pair each hole with the smallest outer border of its plane that holds its first point;
///  2. measure pieces and planes in a basis on the plane;
///  3. tell front from back (plane_view.hpp);
///  4. find the axis that points up (UpAxis).
PlaneScene plane_scene(const PlaneMap& map, UpAxis up, std::span<const Pose> camera_path);

/// Where the eye stands in an oblique view of the upright scene, in degrees from x to y: −60 (from the front,
/// a little from the right), or one of the other three corners if clearly more of the planes turn their
/// fronts to it.
int oblique_turn(const PlaneScene& scene);

/// The vector as x right, y back, z up.
constexpr Vector3 upright(const Vector3& p, UpAxis up) noexcept {
  if (up == UpAxis::y) return {p.x, -p.z, p.y};
  if (up == UpAxis::minus_y) return {p.x, p.z, -p.y};
  return p;
}

}  // namespace straightedge::io
