// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "localize/tracker.hpp"
#include "support/catch.hpp"
#include "support/laser_run.hpp"

using namespace straightedge;
using namespace straightedge::localize;
using namespace support;

namespace {

/// The map as somebody measured it: each line off by what its covariance says.
LineMap measured_map(const Room& room, double sigma_angle, double sigma_offset, Pcg32& random) {
  Room wrong = room;
  for (RoomWall& wall : wrong) {
    const double turn = sigma_angle * normal(random), shift = sigma_offset * normal(random);
    const double dx = (wall.b.x - wall.a.x) / 2, dy = (wall.b.y - wall.a.y) / 2;
    const double half = std::hypot(dx, dy);
    const Point2 middle{wall.a.x + dx - shift * dy / half, wall.a.y + dy + shift * dx / half};
    const double c = std::cos(turn), s = std::sin(turn);
    wall.a = {middle.x - (c * dx - s * dy), middle.y - (s * dx + c * dy)};
    wall.b = {middle.x + (c * dx - s * dy), middle.y + (s * dx + c * dy)};
  }
  return map_of(wrong, sigma_angle, sigma_offset);
}

LocalizeOptions without_floors(const Pose2& start) {
  LocalizeOptions options = started_at(start);
  options.lines.angle_floor_rad = 0;
  options.lines.offset_floor_m = 0;
  options.match.wall_angle_floor_rad = 0;
  options.match.wall_offset_floor_m = 0;
  options.start_covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-5};
  return options;
}

Scanner real_scanner() {
  Scanner scanner = circle_scanner(360);
  scanner.range_sigma_m = 0.02;
  scanner.bearing_sigma_rad = 0.002;
  scanner.laser_in_robot = {0.2, 0.05, 0.3};
  return scanner;
}

}  // namespace

TEST_CASE("the covariance is that of the errors, run after run") {
  double sum = 0;
  int count = 0;
  const int runs = 40;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Pcg32 random(seed);
    const Room room = crooked_room();
    Odometry odometry;
    odometry.scale = 0.04 * normal(random);
    odometry.drift_per_m = 0.015 * normal(random);
    Pose2 start = on_the_way(0);
    start.x_m += 0.01 * normal(random);
    start.y_m += 0.01 * normal(random);
    start.heading_rad += 0.003 * normal(random);
    auto localizer = Localizer::create(measured_map(room, 0.003, 0.02, random), without_floors(start));
    REQUIRE(localizer);
    for (int step = 0; step < 60; ++step) {
      const Pose2 truth = on_the_way(3 * step);
      const Pose2 motion = step == 0 ? Pose2{} : motion_between(on_the_way(3 * step - 3), truth);
      LaserScan scan = scan_of(room, truth, real_scanner(), random);
      scan.time_s = step;
      const LocalizeResult& result = localizer->step(scan, odometry.drive(motion, random));
      REQUIRE(result.has_pose);
      sum += nees(result, truth);
      ++count;
    }
  }
  CAPTURE(runs);
  // 3 is ideal. The errors of one run hang together: 40 runs leave about 0.3 of uncertainty.
  CHECK(sum / count > 1.5);
  CHECK(sum / count < 4.5);
}

TEST_CASE("seeing one wall a thousand times does not make the pose more certain than the wall") {
  const Room room = closed_room({{0, 0}, {8, 0}, {8, 5}, {0, 5}});
  const Pose2 robot{3, 2, 0.5};
  const auto sigma_after = [&](int scans) {
    Pcg32 random(5);
    auto localizer = Localizer::create(map_of(room, 0.002, 0.05), without_floors(robot));
    REQUIRE(localizer);
    LocalizeOptions options = without_floors(robot);
    options.start_covariance = {1, 0, 0, 0, 1, 0, 0, 0, 0.01};
    localizer = Localizer::create(map_of(room, 0.002, 0.05), options);
    REQUIRE(localizer);
    for (int i = 0; i < scans; ++i) localizer->step(scan_of(room, robot, real_scanner(), random), Pose2{});
    return std::sqrt(localizer->result().covariance[0]);
  };
  // Two walls across x, each known to 5 cm: 3.5 cm and no better.
  CHECK(sigma_after(10) == Approx(0.05 / std::sqrt(2.0)).epsilon(0.1));
  CHECK(sigma_after(500) == Approx(0.05 / std::sqrt(2.0)).epsilon(0.1));
}

TEST_CASE("the odometry's faults are learnt") {
  const Room room = crooked_room();
  const WallMap map(map_of(room), {});
  LocalizeOptions options;
  Tracker tracker(options);
  tracker.start(belief_at(on_the_way(0), {{0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.001}}, options.motion));
  Pcg32 random(8);
  Odometry odometry;
  odometry.scale = 0.06;
  odometry.drift_per_m = -0.02;
  auto finder = ScanLineFinder::create();
  REQUIRE(finder);
  Pose2 before = odometry.drive({}, random);
  for (int step = 1; step < 400; ++step) {
    const Pose2 truth = on_the_way(3 * step);
    const Pose2 now = odometry.drive(motion_between(on_the_way(3 * step - 3), truth), random);
    tracker.predict(motion_between(before, now), 1);
    before = now;
    REQUIRE(finder->run(scan_of(room, truth, real_scanner(), random)));
    LocalizeResult result;
    result.lines = finder->lines();
    Readings readings;
    choose_readings(finder->points(), real_scanner().laser_in_robot, 60, readings);
    tracker.correct(map, readings, 0.12, result);
    REQUIRE_FALSE(tracker.lost());
  }
  CHECK(tracker.belief().scale == Approx(1 / 1.06 - 1).margin(0.01));
  CHECK(tracker.belief().drift == Approx(0.02).margin(0.006));
  CHECK(std::sqrt(tracker.belief().covariance(3, 3)) < 0.01);
}

TEST_CASE("prediction: the derivatives are those of small steps") {
  const MotionOptions quiet{0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const Pose2 motion{0.7, 0.2, 0.3};
  PoseBelief at = belief_at({1, 2, 0.5}, {}, quiet);
  at.scale = 0.05;
  at.drift = -0.1;
  PoseBelief there = at;
  predict(there, motion, quiet);
  const double step = 1e-6;
  for (std::size_t i = 0; i < state_size; ++i) {
    PoseBelief moved = at, uncertain = at;
    double* const numbers[] = {&moved.pose.x_m, &moved.pose.y_m, &moved.pose.heading_rad, &moved.scale,
                               &moved.drift};
    *numbers[i] += step;
    predict(moved, motion, quiet);
    // One number alone is uncertain by 1: the column of the derivatives is seen in the covariance.
    uncertain.covariance(i, i) = 1;
    predict(uncertain, motion, quiet);
    CAPTURE(i);
    const double d[] = {(moved.pose.x_m - there.pose.x_m) / step, (moved.pose.y_m - there.pose.y_m) / step,
                        (moved.pose.heading_rad - there.pose.heading_rad) / step};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(uncertain.covariance(r, c) == Approx(d[r] * d[c]).margin(1e-4));
    }
  }
}

TEST_CASE("prediction: the covariance is that of many robots driving blindly") {
  MotionOptions options;
  options.scale = 0.04;
  options.drift_per_m = 0.02;
  const Pose2 step{0.5, 0, 0.1};
  PoseBelief belief = belief_at({}, {}, options);
  for (int i = 0; i < 20; ++i) predict(belief, step, options);
  const int robots = 4000;
  Matrix3 spread;
  Pcg32 random(9);
  for (int k = 0; k < robots; ++k) {
    const double scale = options.scale * normal(random), drift = options.drift_per_m * normal(random);
    Pose2 pose;
    for (int i = 0; i < 20; ++i) {
      const double way = options.along_per_m * 0.5 + options.along_per_rad * 0.1 + options.along_m;
      const double turn = options.turn_per_rad * 0.1 + options.turn_per_m * 0.5 + options.turn_rad;
      const double bend = drift * 0.5 + turn * normal(random);
      const Pose2 driven = compose({0, 0, bend / 2}, {(1 + scale) * 0.5 + way * normal(random),
                                                      way * normal(random), step.heading_rad + bend / 2});
      pose = compose(pose, driven);
    }
    const double e[] = {pose.x_m - belief.pose.x_m, pose.y_m - belief.pose.y_m,
                        wrap_angle(pose.heading_rad - belief.pose.heading_rad)};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) spread(r, c) += e[r] * e[c] / robots;
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    CAPTURE(r);
    CHECK(belief.covariance(r, r) == Approx(spread(r, r)).epsilon(0.15));
  }
}
