// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/wall_map.hpp"

#include <cmath>
#include <limits>

#include "localize/scan_fit.hpp"
#include "support/catch.hpp"
#include "support/laser_room.hpp"

using namespace straightedge;
using namespace straightedge::localize;
using namespace support;

namespace {

Room random_walls(Pcg32& random, int count, double size) {
  Room room;
  for (int i = 0; i < count; ++i) {
    const Point2 a{uniform(random, -size, size), uniform(random, -size, size)};
    room.push_back({a, {a.x + uniform(random, -8, 8), a.y + uniform(random, -8, 8)}});
  }
  return room;
}

double distance_to(const RoomWall& wall, double x, double y) {
  const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y;
  const double u =
      std::fmax(0, std::fmin(1, ((x - wall.a.x) * dx + (y - wall.a.y) * dy) / (dx * dx + dy * dy)));
  return std::hypot(x - wall.a.x - u * dx, y - wall.a.y - u * dy);
}

/// The wall without 10 cm at each end, as the map takes it for rays.
RoomWall shortened(RoomWall wall) {
  const double length = std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y);
  const double tx = (wall.b.x - wall.a.x) / length, ty = (wall.b.y - wall.a.y) / length;
  wall.a = {wall.a.x + 0.1 * tx, wall.a.y + 0.1 * ty};
  wall.b = {wall.b.x - 0.1 * tx, wall.b.y - 0.1 * ty};
  return wall;
}

}  // namespace

TEST_CASE("distances and crossings are those of trying every wall") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Pcg32 random(seed);
    const Room room = random_walls(random, 40, seed % 2 == 0 ? 20 : 300);
    Room short_walls;
    for (const RoomWall& wall : room) short_walls.push_back(shortened(wall));
    const WallMap map(map_of(room), {});
    for (int i = 0; i < 300; ++i) {
      const double x = uniform(random, -25, 25), y = uniform(random, -25, 25);
      double nearest = 0.7;
      for (const RoomWall& wall : room) nearest = std::fmin(nearest, distance_to(wall, x, y));
      CAPTURE(seed, i, x, y);
      CHECK(map.distance(x, y, 0.7) == Approx(nearest).margin(1e-9));
      const double angle = uniform(random, -pi, pi);
      const double range = range_to(short_walls, {x, y}, angle);
      const auto crossing = map.first_crossing(x, y, std::cos(angle), std::sin(angle), 30);
      CHECK(crossing.has_value() == (range < 30));
      if (crossing) CHECK(crossing->distance_m == Approx(range).margin(1e-6));
    }
  }
}

TEST_CASE("rays along the axes and from outside the grid") {
  const WallMap map(map_of({{{10, -1}, {10, 1}}}), {});
  REQUIRE(map.first_crossing(-100, 0, 1, 0, 200));
  CHECK(map.first_crossing(-100, 0, 1, 0, 200)->distance_m == Approx(110));
  CHECK_FALSE(map.first_crossing(-100, 0, 1, 0, 100));
  CHECK_FALSE(map.first_crossing(-100, 0, -1, 0, 1e6));
  CHECK_FALSE(map.first_crossing(-100, 0, 0, 1, 1e6));
  CHECK_FALSE(map.first_crossing(10, 0, 0, 1, 100));  // along the wall
  CHECK(map.distance(1e9, 0, 0.5) == 0.5);
  CHECK(map.distance(std::numeric_limits<double>::quiet_NaN(), 0, 0.5) == 0.5);
}

TEST_CASE("what is wrong with a map is told in a sentence") {
  const LineMap good = map_of(crooked_room());
  CHECK(objection_to(good) == nullptr);
  const auto refused = [&](auto change) {
    LineMap map = good;
    change(map);
    return objection_to(map) != nullptr;
  };
  const double bad = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused([](LineMap& m) { m.unit = MapUnit::pixel; }));
  CHECK(refused([](LineMap& m) { m.lines.clear(); }));
  CHECK(refused([](LineMap& m) {
    for (MapLine& line : m.lines) line.segments.clear();
  }));
  CHECK(refused([&](LineMap& m) { m.lines[3].segments[0].x1 = bad; }));
  CHECK(refused([&](LineMap& m) { m.lines[3].theta = bad; }));
  CHECK(refused([](LineMap& m) { m.lines[2].segments[0].y0 = 1e7; }));
  CHECK(refused([](LineMap& m) { m.lines[2].covariance->var_offset = -1; }));
  CHECK(refused([&](LineMap& m) { m.lines[2].covariance->at_x = bad; }));
}

TEST_CASE("readings on walls, before them, behind them, nowhere") {
  const WallMap map(map_of({{{3, -5}, {3, 5}}}), {});
  Readings readings;
  const auto fit_of = [&](double x, double y) {
    readings.ends = {{x, y}};
    return score_pose(map, {}, readings, 0.15);
  };
  CHECK(fit_of(3.05, 0).fit.on_walls == 1);
  CHECK(fit_of(2, 0).fit.before_walls == 1);
  CHECK(fit_of(4, 0).fit.through_walls == 1);
  CHECK(fit_of(-2, 0).fit.nowhere == 1);
  CHECK(fit_of(3, 0).log_likelihood > fit_of(3.1, 0).log_likelihood);
  CHECK(fit_of(3.1, 0).log_likelihood > fit_of(2, 0).log_likelihood);
  CHECK(fit_of(2, 0).log_likelihood > fit_of(4, 0).log_likelihood);
  // The pose and the place of the laser are taken into account.
  readings.ends = {{3, 0}};
  CHECK(score_pose(map, {3, -3, pi / 2}, readings, 0.15).fit.on_walls == 1);
  readings.laser_x_m = 5;
  CHECK(score_pose(map, {0, 0, 0}, readings, 0.15).fit.on_walls == 1);
  CHECK(score_pose(map, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, readings, 0.15).fit.on_walls == 0);
  readings.ends.clear();
  CHECK(score_pose(map, {}, readings, 0.15).log_likelihood == 0);
}
