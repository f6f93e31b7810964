// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "map/wall_line.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "support/catch.hpp"

/// Lines made by hand for the stages of the line map. Coordinates are columns and rows as in WallLine.
namespace stage {

using straightedge::Point2;
using straightedge::WallLine;

/// A face from a to b with the light side on its left when rows count downwards, carried by exact points, one
/// a pixel.
inline WallLine face(Point2 a, Point2 b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double tx = (b.x - a.x) / length, ty = (b.y - a.y) / length;
  WallLine line;
  line.origin_x = a.x;
  line.origin_y = a.y;
  const int steps = static_cast<int>(length);
  for (int i = 0; i <= steps; ++i) line.moments.add(tx * length * i / steps, ty * length * i / steps, 16);
  REQUIRE(fit_line(line.moments, line.fit) == straightedge::Status::ok);
  line.fit.centroid_x += a.x;
  line.fit.centroid_y += a.y;
  line.nx = ty;
  line.ny = -tx;
  line.begin = -length / 2;
  line.end = length / 2;
  line.pixels = static_cast<std::uint32_t>(steps + 1);
  line.votes = line.pixels;
  return line;
}

inline WallLine axis(Point2 a, Point2 b, double width = 2) {
  WallLine line = face(a, b);
  line.axis = true;
  line.width = width;
  return line;
}

inline Point2 begin_of(const WallLine& line) {
  return {line.x_at(line.begin), line.y_at(line.begin)};
}
inline Point2 end_of(const WallLine& line) {
  return {line.x_at(line.end), line.y_at(line.end)};
}

inline void check_ends(const WallLine& line, Point2 a, Point2 b, double margin) {
  CHECK(begin_of(line).x == Approx(a.x).margin(margin));
  CHECK(begin_of(line).y == Approx(a.y).margin(margin));
  CHECK(end_of(line).x == Approx(b.x).margin(margin));
  CHECK(end_of(line).y == Approx(b.y).margin(margin));
}

}  // namespace stage
