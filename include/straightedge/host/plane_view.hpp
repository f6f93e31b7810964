// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/pose.hpp"

/// Pictures of plane maps. Both draw from back to front, and pale what is looked at from behind, so that
/// one looks into a room over its near walls and under its ceiling. A plane's front is the side from which it
/// was seen; where the map does not say, the side on which nearly all of the other planes lie; else both.
/// Polygons with fewer than three points, and what has numbers that are not finite or beyond 1e9 m, are left
/// out. The same input gives the same bytes. A plane has the same colour in every picture: plane_colour of
/// its id.
namespace straightedge {

/// Which axis of the map points up.
enum class UpAxis : std::uint8_t {
  /// With a camera path: the axis of the three below to which the cameras' upper sides point on the whole (a
  /// tie goes to the first). Without one: minus_y when the whole map lies in a cone that a camera at the
  /// origin would see (z > 0, |x| and |y| at most 1.2 z), as the map of a single frame does; else z.
  automatic,
  z,        ///< robots, most worlds
  y,        ///< computer graphics
  minus_y,  ///< cameras: x right, y down, z forward
};

/// A reading of the map, to be shown as a dot in the colour of its plane.
struct PlaneViewPoint {
  Vector3 at;               ///< world, metres
  std::uint32_t plane = 0;  ///< id; 0, or an id that the map does not have: a gray dot
};

struct PlaneViewOptions {
  std::string title;  ///< none: the map's name
  UpAxis up = UpAxis::automatic;
  std::span<const Pose> camera_path;  ///< world_from_camera, in the order of the frames
  std::span<const PlaneViewPoint> points;
  std::size_t max_points = 200'000;  ///< of more than these every n-th is kept
};

/// One HTML page that needs nothing else: no network, no WebGL, no library. The map can be turned, moved and
/// magnified by mouse, touch and keyboard; a list has the numbers of its planes and switches
/// them on and off. The part of its address behind `#` sets the view: `view=iso|top|front|side`, `turn=` and
/// `tilt=` in degrees, `zoom=`, `select=ID`, and `points=`, `ids=`, `path=`, `perspective=` with 0 or 1,
/// joined by `&`. Coordinates are rounded to a millimetre, finer in maps of less than 5 m. Time and size grow
/// with vertices and points, and the square of the number of borders.
std::string plane_map_html(const PlaneMap& map, const PlaneViewOptions& options = {});

struct PlaneSvgOptions {
  std::string title;  ///< none: the map's name
  UpAxis up = UpAxis::automatic;
  std::span<const Pose> camera_path;
  bool ids = true;
};

/// A drawing with two views side by side, each with its scale bar: a plan from above, in which walls
/// are thick lines, and a parallel projection obliquely from above, from the corner to which most planes turn
/// their fronts. An id stands on its plane or is led to it by a thin line; ids do not overlap, and where
/// there is no room for one it is left out.
std::string plane_map_svg(const PlaneMap& map, const PlaneSvgOptions& options = {});

}  // namespace straightedge
