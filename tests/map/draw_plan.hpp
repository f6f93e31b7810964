// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

/// Drawings of buildings with their truth, and line maps looked at in the drawing's own frame: the image
/// plane, u right, v down.
namespace plan {

using straightedge::LineMap;
using straightedge::MapLine;
using straightedge::MapSegment;
using straightedge::Point2;
using straightedge::Size;

/// A piece of wall that the map should have: an axis or a face.
struct Wall {
  Point2 a, b;
  double length() const { return std::hypot(b.x - a.x, b.y - a.y); }
};

/// A segment of the map with the line that it belongs to.
struct Found {
  Wall wall;
  MapLine line;
};

inline std::vector<Found> found_in(const LineMap& map) {
  std::vector<Found> out;
  for (const MapLine& line : map.lines) {
    for (const MapSegment& segment : line.segments) {
      out.push_back({{image_from_centre(first_end(segment), map.image->size),
                      image_from_centre(second_end(segment), map.image->size)},
                     line});
    }
  }
  return out;
}

/// Builds the map, which must succeed and keep every rule of the format.
inline straightedge::LineMapResult build(straightedge::GrayView picture,
                                         const straightedge::LineMapOptions& options = {}) {
  auto result = straightedge::build_line_map(picture, options);
  INFO((result ? std::string() : result.failure().sentence));
  REQUIRE(static_cast<bool>(result));
  const auto breaches = straightedge::check_line_map(result->map);
  INFO((breaches.empty() ? std::string() : breaches.front().sentence));
  REQUIRE(breaches.empty());
  return std::move(*result);
}

/// Edges followed, which is the default, and voted for by each Hough transform.
inline std::vector<straightedge::LineMapOptions> all_methods() {
  using straightedge::HoughMethod;
  std::vector<straightedge::LineMapOptions> all(1);
  for (const HoughMethod method :
       {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
    all.push_back({.hough = straightedge::line_map_hough});
    all.back().hough->method = method;
  }
  return all;
}

inline std::vector<Found> walls_in(const support::Canvas& canvas,
                                   const straightedge::LineMapOptions& options = {}) {
  return found_in(build(canvas.picture(), options).map);
}

/// Signed distance of a point from a wall's infinite line, positive to the left of a to b.
inline double distance_from(const Wall& wall, Point2 p) {
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y;
  return (dx * (p.y - wall.a.y) - dy * (p.x - wall.a.x)) / std::hypot(dx, dy);
}

/// Where the point's foot lies along a to b, pixels from a.
inline double along(const Wall& wall, Point2 p) {
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y;
  return (dx * (p.x - wall.a.x) + dy * (p.y - wall.a.y)) / std::hypot(dx, dy);
}

inline Point2 middle(const Wall& wall) {
  return {(wall.a.x + wall.b.x) / 2, (wall.a.y + wall.b.y) / 2};
}

/// Angle between two walls, their directions modulo half a turn.
inline double angle_between(const Wall& p, const Wall& q) {
  const double cross = (p.b.x - p.a.x) * (q.b.y - q.a.y) - (p.b.y - p.a.y) * (q.b.x - q.a.x);
  return std::asin(std::fmin(1, std::fabs(cross) / (p.length() * q.length())));
}

/// How far the found segment's line is from the middle of the true one.
inline double offset_error(const Wall& found, const Wall& truth) {
  return std::fabs(distance_from(found, middle(truth)));
}

/// The larger distance of the true ends from the found ones, ends paired as they lie nearer.
inline double end_error(const Wall& found, const Wall& truth) {
  const auto apart = [](Point2 p, Point2 q) { return std::hypot(p.x - q.x, p.y - q.y); };
  return std::fmin(std::fmax(apart(found.a, truth.a), apart(found.b, truth.b)),
                   std::fmax(apart(found.a, truth.b), apart(found.b, truth.a)));
}

/// The side of the line's normal on which a point of the drawing lies.
inline bool on_plus_side(const MapLine& line, Point2 uv, Size size) {
  return straightedge::signed_distance(centre_from_image(uv, size), line.rho, line.theta) > 0;
}

/// The found segments that lie along a true wall: at most 2 degrees and `reach` pixels off.
inline std::vector<Found> beside(const std::vector<Found>& found, const Wall& truth, double reach = 1) {
  std::vector<Found> out;
  for (const Found& f : found) {
    const double s = along(truth, middle(f.wall));
    if (angle_between(f.wall, truth) > 2 * straightedge::degree || s < 0 || s > truth.length()) continue;
    if (std::fabs(distance_from(truth, f.wall.a)) > reach ||
        std::fabs(distance_from(truth, f.wall.b)) > reach)
      continue;
    out.push_back(f);
  }
  return out;
}

}  // namespace plan
