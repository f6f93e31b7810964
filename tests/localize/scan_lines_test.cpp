// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/scan_lines.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/laser_room.hpp"

using namespace straightedge;
using namespace support;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

ScanLineFinder finder(const ScanLineOptions& options = {}) {
  auto made = ScanLineFinder::create(options);
  REQUIRE(made);
  return *made;
}

/// A wall 3 m ahead of the robot, 4 m long.
const Room wall_ahead{{{3, -2}, {3, 2}}};

}  // namespace

TEST_CASE("a wall ahead is one line, its normal points to the laser") {
  ScanLineFinder lines = finder();
  REQUIRE(lines.run(exact_scan(wall_ahead, {})));
  REQUIRE(lines.lines().size() == 1);
  const ScanLine& line = lines.lines()[0];
  CHECK(std::fabs(wrap_angle(line.theta_rad - pi)) < 1e-6);
  CHECK(line.normal_x == Approx(-1));
  CHECK(line.centroid_x_m == Approx(3).epsilon(1e-6));
  CHECK(line.y0_m == Approx(-2).margin(0.05));  // the floor on the left of the way from end 0 to end 1
  CHECK(line.y1_m == Approx(2).margin(0.05));
  CHECK(line.x0_m == Approx(3).epsilon(1e-6));
  CHECK(line.residual_m < 1e-6);
  CHECK(line.first_beam < line.last_beam);
  CHECK(line.points == line.last_beam - line.first_beam + 1);
  CHECK(lines.counts().beams == 361);
  CHECK(lines.counts().no_reading == 361 - line.points);
}

TEST_CASE("a corner gives two lines that meet in it") {
  ScanLineFinder lines = finder();
  REQUIRE(lines.run(exact_scan({{{3, -2}, {3, 2}}, {{3, 2}, {-3, 2}}}, {})));
  REQUIRE(lines.lines().size() == 2);
  CHECK(std::fabs(lines.lines()[0].normal_x) > 0.999);
  CHECK(std::fabs(lines.lines()[1].normal_y) > 0.999);
  CHECK(std::hypot(lines.lines()[0].x1_m - 3, lines.lines()[0].y1_m - 2) < 0.1);
  CHECK(std::hypot(lines.lines()[1].x0_m - 3, lines.lines()[1].y0_m - 2) < 0.1);
}

TEST_CASE("what is no reading is counted and tears no wall") {
  LaserScan scan = exact_scan(wall_ahead, {});
  const std::size_t middle = scan.ranges_m.size() / 2;
  scan.ranges_m[middle] = not_a_number;
  scan.ranges_m[middle + 1] = endless;
  scan.ranges_m[middle + 2] = 0;
  scan.ranges_m[middle + 3] = -2;
  scan.ranges_m[0] = 80;
  scan.ranges_m[1] = 90;
  scan.max_range_m = 80;
  ScanLineFinder lines = finder();
  REQUIRE(lines.run(scan));
  CHECK(lines.lines().size() == 1);
  CHECK(lines.counts().beyond_range == 2);
  ScanLineFinder whole = finder();
  REQUIRE(whole.run(exact_scan(wall_ahead, {})));
  CHECK(lines.counts().no_reading == whole.counts().no_reading + 2);
  CHECK(lines.lines()[0].points == whole.lines()[0].points - 4);
}

TEST_CASE("no circle of lines comes from readings at the maximum range") {
  LaserScan scan = exact_scan({}, {});
  for (float& range : scan.ranges_m) range = 8;
  scan.max_range_m = 8;
  ScanLineFinder lines = finder();
  REQUIRE(lines.run(scan));
  CHECK(lines.lines().empty());
  CHECK(lines.points().empty());
}

TEST_CASE("a wall across the seam of a circle is whole") {
  ScanLineFinder lines = finder();
  REQUIRE(lines.run(exact_scan(wall_ahead, {}, circle_scanner())));
  REQUIRE(lines.lines().size() == 1);
  CHECK(lines.lines()[0].first_beam > lines.lines()[0].last_beam);
  CHECK(std::fabs(lines.lines()[0].y0_m - lines.lines()[0].y1_m) == Approx(4).margin(0.1));
}

TEST_CASE("few points are no line, and no fault") {
  ScanLineFinder lines = finder();
  LaserScan scan;
  scan.angle_step_rad = 0.01;
  for (const std::size_t count : {0U, 1U, 2U, 4U}) {
    scan.ranges_m.assign(count, 2.0F);
    CAPTURE(count);
    REQUIRE(lines.run(scan));
    CHECK(lines.lines().empty());
    CHECK(lines.points().size() == count);
  }
}

TEST_CASE("a sparse scan: twelve beams see the two long walls of a corridor") {
  ScanLineOptions options;
  options.max_gap_m = 1.5;
  options.min_points = 3;
  ScanLineFinder lines = finder(options);
  REQUIRE(lines.run(
      exact_scan(closed_room({{-9, -1}, {9, -1}, {9, 1}, {-9, 1}}), {0, 0, 0.26}, circle_scanner(12))));
  REQUIRE(lines.lines().size() == 2);
  for (const ScanLine& line : lines.lines())
    CHECK(std::fabs(wrap_angle(2 * (line.theta_rad + 0.26) - pi)) < 1e-3);
}

TEST_CASE("points in one place and equal ranges") {
  ScanLineFinder lines = finder();
  LaserScan scan;
  scan.angle_step_rad = 1e-9;
  scan.ranges_m.assign(100, 5.0F);
  REQUIRE(lines.run(scan));
  CHECK(lines.lines().empty());
}

TEST_CASE("scans that cannot be used") {
  ScanLineFinder lines = finder();
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto change) {
    LaserScan scan = exact_scan(wall_ahead, {});
    REQUIRE(lines.run(scan));
    change(scan);
    return !lines.run(scan) && lines.lines().empty() && lines.points().empty();
  };
  CHECK(refused([&](LaserScan& s) { s.angle_step_rad = 0; }));
  CHECK(refused([&](LaserScan& s) { s.angle_step_rad = bad; }));
  CHECK(refused([&](LaserScan& s) { s.first_angle_rad = bad; }));
  CHECK(refused([&](LaserScan& s) { s.max_range_m = bad; }));
  CHECK(refused([&](LaserScan& s) { s.laser_in_robot.x_m = 1e300; }));
  CHECK(refused([&](LaserScan& s) { s.laser_in_robot.heading_rad = bad; }));
}

TEST_CASE("options out of their range are refused with a sentence") {
  const auto refused = [](auto change) {
    ScanLineOptions options;
    change(options);
    const auto made = ScanLineFinder::create(options);
    return !made && made.failure().problem == Problem::bad_option && !made.failure().sentence.empty();
  };
  const double bad = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused([](ScanLineOptions& o) { o.range_sigma_m = 0; }));
  CHECK(refused([&](ScanLineOptions& o) { o.range_sigma_m = bad; }));
  CHECK(refused([](ScanLineOptions& o) { o.bearing_sigma_rad = -1; }));
  CHECK(refused([](ScanLineOptions& o) { o.split_distance_m = 0; }));
  CHECK(refused([](ScanLineOptions& o) { o.max_gap_m = 1000; }));
  CHECK(refused([&](ScanLineOptions& o) { o.min_length_m = bad; }));
  CHECK(refused([](ScanLineOptions& o) { o.min_points = 2; }));
  CHECK(refused([](ScanLineOptions& o) { o.angle_floor_rad = 1; }));
  CHECK(refused([](ScanLineOptions& o) { o.offset_floor_m = -1; }));
}

TEST_CASE("all three methods find the walls of a room, and nothing else") {
  const ScanLineMethod method =
      GENERATE(ScanLineMethod::split_and_merge, ScanLineMethod::ransac, ScanLineMethod::hough);
  CAPTURE(static_cast<int>(method));
  ScanLineOptions options;
  options.method = method;
  options.min_length_m = 0.6;
  options.min_points = 10;
  ScanLineFinder lines = finder(options);
  const Pose2 robot{6, 2, 0.4};
  const Room room = closed_room({{0, 0}, {12, 0}, {12, 5}, {7, 5}, {7, 9}, {2, 9}, {0, 7}});
  Scanner scanner = circle_scanner();
  scanner.range_sigma_m = 0.01;
  Pcg32 random(7);
  REQUIRE(lines.run(scan_of(room, robot, scanner, random)));
  std::vector<int> seen(room.size());
  for (const ScanLine& line : lines.lines()) {
    bool known = false;
    for (std::size_t i = 0; i < room.size(); ++i) {
      const auto wall = line_through(room[i].a, room[i].b);
      const double turn = wrap_angle(2 * (wall.theta - line.theta_rad - robot.heading_rad)) / 2;
      const double c = std::cos(robot.heading_rad), s = std::sin(robot.heading_rad);
      const Point2 centre{robot.x_m + c * line.centroid_x_m - s * line.centroid_y_m,
                          robot.y_m + s * line.centroid_x_m + c * line.centroid_y_m};
      if (std::fabs(turn) > 0.03 || std::fabs(signed_distance(centre, wall.rho, wall.theta)) > 0.03) continue;
      known = true;
      ++seen[i];
    }
    CHECK(known);
  }
  // From there the wall from (7, 5) to (7, 9) shows its end alone, the others more than half of them.
  for (const std::size_t i : {0U, 1U, 2U, 5U, 6U}) {
    CAPTURE(i);
    CHECK(seen[i] >= 1);
  }
}

TEST_CASE("a finder that has seen other scans gives the same lines as a new one") {
  const ScanLineMethod method =
      GENERATE(ScanLineMethod::split_and_merge, ScanLineMethod::ransac, ScanLineMethod::hough);
  ScanLineOptions options;
  options.method = method;
  ScanLineFinder used = finder(options), fresh = finder(options);
  const Room room = crooked_room();
  REQUIRE(used.run(exact_scan(room, {6, 2, 1}, circle_scanner(1440))));
  REQUIRE(used.run(exact_scan(room, {1, 1, 0})));
  REQUIRE(used.run(LaserScan{0, 0, 0.1, 0, {}, {}}));
  const LaserScan scan = exact_scan(room, {6, 3, 2}, circle_scanner(500));
  REQUIRE(used.run(scan));
  REQUIRE(fresh.run(scan));
  REQUIRE(used.lines().size() == fresh.lines().size());
  for (std::size_t i = 0; i < used.lines().size(); ++i) {
    CHECK(used.lines()[i].theta_rad == fresh.lines()[i].theta_rad);
    CHECK(used.lines()[i].x0_m == fresh.lines()[i].x0_m);
    CHECK(used.lines()[i].var_offset == fresh.lines()[i].var_offset);
  }
}
