// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "straightedge/host/laser_scan.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/random.hpp"
#include "support/drawing.hpp"

/// Rooms of straight walls, what a laser scanner sees in them, and their exact line maps.
namespace support {

using straightedge::FreeSide;
using straightedge::LaserScan;
using straightedge::LineCovariance;
using straightedge::LineMap;
using straightedge::MapLine;
using straightedge::Pcg32;
using straightedge::Point2;
using straightedge::Pose2;

struct RoomWall {
  Point2 a, b;
  FreeSide free = FreeSide::unknown;
};
using Room = std::vector<RoomWall>;

/// Walls along the corners, one after another and back to the first; the floor on the left of the way.
inline Room closed_room(const std::vector<Point2>& corners) {
  Room room;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    RoomWall wall{corners[i], corners[(i + 1) % corners.size()]};
    const auto line = straightedge::line_through(wall.a, wall.b);
    const Point2 left{wall.a.x - (wall.b.y - wall.a.y), wall.a.y + (wall.b.x - wall.a.x)};
    wall.free =
        straightedge::signed_distance(left, line.rho, line.theta) > 0 ? FreeSide::plus : FreeSide::minus;
    room.push_back(wall);
  }
  return room;
}

/// No two views of it are alike: an L with a slanted wall and a box.
inline Room crooked_room() {
  Room room = closed_room({{0, 0}, {12, 0}, {12, 5}, {7, 5}, {7, 9}, {2, 9}, {0, 7}});
  for (const RoomWall& wall : closed_room({{3, 3}, {3, 4}, {4.5, 4}, {4.5, 3}})) room.push_back(wall);
  return room;
}

/// Each wall a line of its own, in metres.
inline LineMap map_of(const Room& room, double sigma_angle = 0.001, double sigma_offset = 0.005) {
  LineMap map;
  map.unit = straightedge::MapUnit::metre;
  for (std::uint32_t i = 0; i < room.size(); ++i) {
    const auto form = straightedge::line_through(room[i].a, room[i].b);
    MapLine line;
    line.id = 100 + i;
    line.rho = form.rho;
    line.theta = form.theta;
    line.free = room[i].free;
    line.covariance = LineCovariance{(room[i].a.x + room[i].b.x) / 2, (room[i].a.y + room[i].b.y) / 2,
                                     sigma_angle * sigma_angle, sigma_offset * sigma_offset};
    line.segments.push_back({200 + i, room[i].a.x, room[i].a.y, room[i].b.x, room[i].b.y, {}});
    straightedge::order_ends(line.segments.back(), line.theta);
    map.lines.push_back(line);
  }
  return map;
}

struct Scanner {
  int beams = 361;
  double first_angle_rad = -straightedge::pi / 2;
  double angle_step_rad = straightedge::pi / 360;
  double max_range_m = 0;
  Pose2 laser_in_robot;
  double range_sigma_m = 0;
  double bearing_sigma_rad = 0;
};

/// The whole circle, its seam straight ahead.
inline Scanner circle_scanner(int beams = 720) {
  Scanner scanner;
  scanner.beams = beams;
  scanner.first_angle_rad = 0;
  scanner.angle_step_rad = 2 * straightedge::pi / beams;
  return scanner;
}

/// Along the beam to the first wall; infinite without.
inline double range_to(const Room& room, Point2 from, double angle) {
  const double dx = std::cos(angle), dy = std::sin(angle);
  double nearest = std::numeric_limits<double>::infinity();
  for (const RoomWall& wall : room) {
    const double ex = wall.b.x - wall.a.x, ey = wall.b.y - wall.a.y;
    const double cross = dx * ey - dy * ex;
    if (cross == 0) continue;
    const double px = wall.a.x - from.x, py = wall.a.y - from.y;
    const double range = (px * ey - py * ex) / cross, share = (px * dy - py * dx) / cross;
    if (range > 0 && share >= 0 && share <= 1) nearest = std::fmin(nearest, range);
  }
  return nearest;
}

inline LaserScan scan_of(const Room& room, const Pose2& robot, const Scanner& scanner, Pcg32& random) {
  LaserScan scan;
  scan.first_angle_rad = scanner.first_angle_rad;
  scan.angle_step_rad = scanner.angle_step_rad;
  scan.max_range_m = scanner.max_range_m;
  scan.laser_in_robot = scanner.laser_in_robot;
  const Pose2 laser = straightedge::compose(robot, scanner.laser_in_robot);
  for (int i = 0; i < scanner.beams; ++i) {
    const double angle = laser.heading_rad + scanner.first_angle_rad + i * scanner.angle_step_rad +
                         scanner.bearing_sigma_rad * normal(random);
    const double range =
        range_to(room, {laser.x_m, laser.y_m}, angle) + scanner.range_sigma_m * normal(random);
    scan.ranges_m.push_back(static_cast<float>(range));
  }
  return scan;
}

inline LaserScan exact_scan(const Room& room, const Pose2& robot, const Scanner& scanner = {}) {
  Pcg32 unused(1);
  return scan_of(room, robot, scanner, unused);
}

/// A way through the crooked room: round the box again and again, without touching a wall.
inline Pose2 on_the_way(int step) {
  const double turn = 0.03 * step;
  const double x = 3.75 + 2.2 * std::cos(turn), y = 3.5 + 2.2 * std::sin(turn);
  return {x, y, straightedge::wrap_angle(turn + straightedge::pi / 2)};
}

}  // namespace support
