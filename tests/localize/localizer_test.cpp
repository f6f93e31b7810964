// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/localizer.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/laser_run.hpp"

using namespace straightedge;
using namespace support;

namespace {

Scanner real_scanner() {
  Scanner scanner;
  scanner.range_sigma_m = 0.015;
  scanner.max_range_m = 30;
  return scanner;
}

Localizer localizer_in(const Room& room, const LocalizeOptions& options = {}) {
  auto made = Localizer::create(map_of(room), options);
  REQUIRE(made);
  return *made;
}

/// Drives the way through the crooked room from one step to another.
class Drive {
 public:
  explicit Drive(std::uint64_t seed) : random_(seed) {}

  Pose2 truth() const { return on_the_way(step_); }

  /// The next scan and the odometry at it.
  const LocalizeResult& next(Localizer& localizer, bool with_odometry = true) {
    const Pose2 before = truth();
    step_ += 2;
    ++scans_;
    const Pose2 says = odometry_.drive(motion_between(before, truth()), random_);
    LaserScan scan = scan_of(crooked_room(), truth(), real_scanner(), random_);
    scan.time_s = 0.1 * scans_;
    return localizer.step(scan, with_odometry ? std::optional<Pose2>(says) : std::nullopt);
  }

  /// Somebody carries the robot; the odometry does not notice.
  void carry(int steps) { step_ += steps; }

 private:
  Pcg32 random_;
  Odometry odometry_;
  int step_ = 0, scans_ = 0;
};

}  // namespace

TEST_CASE("a robot that knows where it starts is followed") {
  const bool with_odometry = GENERATE(true, false);
  const auto association = GENERATE(Association::joint, Association::nearest);
  LocalizeOptions options = started_at(on_the_way(0));
  options.match.association = association;
  Localizer localizer = localizer_in(crooked_room(), options);
  Drive drive(3);
  for (int i = 0; i < 150; ++i) {
    const LocalizeResult& result = drive.next(localizer, with_odometry);
    CAPTURE(i, with_odometry);
    REQUIRE(result.state == LocalizeState::tracking);
    REQUIRE(result.has_pose);
    CHECK(distance(result.pose, drive.truth()) < 0.06);
    CHECK(turn_between(result.pose, drive.truth()) < 0.02);
    CHECK(result.matches.size() == result.lines.size());
    CHECK(result.match_counts.lines == result.lines.size());
    CHECK(result.fit.on_walls > 0.9);
    CHECK(result.scan == ScanVerdict::used);
  }
}

TEST_CASE("a robot that does not know where it is is found within a few scans") {
  for (int start = 0; start < 200; start += 20) {
    Localizer localizer = localizer_in(crooked_room());
    Drive drive(11);
    drive.carry(start);
    int scans = 0;
    while (!localizer.result().has_pose && scans < 20) {
      const LocalizeResult& result = drive.next(localizer);
      ++scans;
      if (result.has_pose) break;
      CHECK(result.state == LocalizeState::searching);
      CHECK(result.search_counts.hypotheses > 0);
    }
    CAPTURE(start, scans);
    CHECK(scans <= 8);
    CHECK(distance(localizer.result().pose, drive.truth()) < 0.1);
    CHECK(turn_between(localizer.result().pose, drive.truth()) < 0.03);
    CHECK(localizer.result().match_counts.matched > 0);
  }
}

TEST_CASE("a robot that was carried off is lost, and found again") {
  Localizer localizer = localizer_in(crooked_room(), started_at(on_the_way(0)));
  Drive drive(17);
  for (int i = 0; i < 20; ++i) REQUIRE(drive.next(localizer).has_pose);
  drive.carry(100);
  int lost_after = 0, found_after = 0;
  for (int i = 1; i <= 60 && found_after == 0; ++i) {
    const LocalizeResult& result = drive.next(localizer);
    if (lost_after == 0 && result.state == LocalizeState::lost) lost_after = i;
    if (lost_after != 0 && result.has_pose) found_after = i;
  }
  CHECK(lost_after > 0);
  CHECK(lost_after <= 10);
  CHECK(found_after > 0);
  CHECK(distance(localizer.result().pose, drive.truth()) < 0.1);
}

TEST_CASE("a room that looks the same from two places gives no pose") {
  const Room room = closed_room({{0, 0}, {8, 0}, {8, 5}, {0, 5}});
  Localizer localizer = localizer_in(room);
  Pcg32 random(2);
  Pose2 robot{2, 2, 0.3};
  Pose2 says;
  for (int i = 0; i < 25; ++i) {
    const Pose2 motion{0.1, 0, 0.02};
    robot = compose(robot, motion);
    says = compose(says, motion);
    const LocalizeResult& result = localizer.step(scan_of(room, robot, circle_scanner(360), random), says);
    REQUIRE_FALSE(result.has_pose);
    REQUIRE(result.state == LocalizeState::searching);
    CHECK(result.search_counts.hypotheses >= 2);
    CHECK(result.match_counts.no_pose == result.lines.size());
  }
}

TEST_CASE("a robot pushed aside between two scans is not lost") {
  Localizer localizer = localizer_in(crooked_room(), started_at(on_the_way(0)));
  Drive drive(19);
  for (int i = 0; i < 20; ++i) REQUIRE(drive.next(localizer).has_pose);
  drive.carry(7);  // half a metre, and a turn of 12 degrees
  for (int i = 0; i < 3; ++i) drive.next(localizer);
  CHECK(localizer.result().state == LocalizeState::tracking);
  CHECK(distance(localizer.result().pose, drive.truth()) < 0.1);
}

TEST_CASE("nothing to see: the pose is predicted, less and less sure") {
  Localizer localizer = localizer_in(crooked_room(), started_at({3, 2, 0}));
  LaserScan blind = exact_scan({}, {});
  double before = 0;
  for (int i = 1; i <= 5; ++i) {
    blind.time_s = i;
    const LocalizeResult& result = localizer.step(blind, Pose2{0.2 * i, 0, 0});
    CHECK(result.scan == ScanVerdict::no_readings);
    CHECK(result.has_pose);
    CHECK(result.pose.x_m == Approx(3 + 0.2 * (i - 1)).margin(1e-9));
    CHECK(result.covariance[0] > before);
    before = result.covariance[0];
  }
  // When nobody knows any more, it is said.
  for (int i = 6; i < 2000 && localizer.result().has_pose; ++i) {
    blind.time_s = i;
    localizer.step(blind, Pose2{0.2 * i, 0, 0});
  }
  CHECK(localizer.result().state == LocalizeState::lost);
}

TEST_CASE("scans that cannot be used are passed over, with a verdict") {
  Localizer localizer = localizer_in(crooked_room(), started_at(on_the_way(0)));
  const double bad = std::numeric_limits<double>::quiet_NaN();
  LaserScan scan = exact_scan(crooked_room(), on_the_way(0));
  scan.time_s = 10;
  REQUIRE(localizer.step(scan, Pose2{}).scan == ScanVerdict::used);
  const Pose2 pose = localizer.result().pose;

  scan.time_s = 9;
  CHECK(localizer.step(scan, Pose2{}).scan == ScanVerdict::time_backwards);
  CHECK(localizer.result().pose == pose);
  CHECK(localizer.result().lines.empty());
  scan.time_s = bad;
  CHECK(localizer.step(scan, Pose2{}).scan == ScanVerdict::unusable);
  CHECK(localizer.result().pose == pose);
  scan.time_s = 11;
  scan.angle_step_rad = 0;
  CHECK(localizer.step(scan, Pose2{}).scan == ScanVerdict::unusable);
  scan = LaserScan{12, 0, 0.1, 0, {}, {}};
  CHECK(localizer.step(scan, Pose2{}).scan == ScanVerdict::no_readings);
  // And then all goes on.
  scan = exact_scan(crooked_room(), on_the_way(0));
  scan.time_s = 13;
  CHECK(localizer.step(scan, Pose2{}).scan == ScanVerdict::used);
  CHECK(localizer.result().has_pose);
  CHECK(distance(localizer.result().pose, on_the_way(0)) < 0.05);
}

TEST_CASE("scans of changing size, and odometry that is none") {
  Localizer localizer = localizer_in(crooked_room(), started_at(on_the_way(0)));
  const double bad = std::numeric_limits<double>::quiet_NaN();
  Pcg32 random(4);
  int i = 0;
  for (const int beams : {361, 180, 1440, 7, 0, 90, 361}) {
    Scanner scanner = circle_scanner(std::max(beams, 1));
    scanner.beams = beams;
    LaserScan scan = scan_of(crooked_room(), on_the_way(0), scanner, random);
    scan.time_s = ++i;
    const LocalizeResult& result = localizer.step(scan, i % 2 == 0 ? Pose2{bad, 0, 0} : Pose2{1e300, 0, 0});
    CAPTURE(beams);
    CHECK(result.has_pose);
  }
  CHECK(distance(localizer.result().pose, on_the_way(0)) < 0.1);
}

TEST_CASE("what was given wrongly is refused with a sentence and the right problem") {
  const LineMap map = map_of(crooked_room());
  const auto problem_of = [](const Result<Localizer>& made) {
    REQUIRE_FALSE(made);
    CHECK(made.failure().sentence.size() > 10);
    return made.failure().problem;
  };
  LineMap pixels = map;
  pixels.unit = MapUnit::pixel;
  CHECK(problem_of(Localizer::create(pixels)) == Problem::bad_content);
  LineMap empty = map;
  empty.lines.clear();
  CHECK(problem_of(Localizer::create(empty)) == Problem::bad_content);
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto change) {
    LocalizeOptions options;
    change(options);
    return problem_of(Localizer::create(map, options)) == Problem::bad_option;
  };
  CHECK(refused([](LocalizeOptions& o) { o.lines.min_points = 1; }));
  CHECK(refused([&](LocalizeOptions& o) { o.motion.along_per_m = bad; }));
  CHECK(refused([](LocalizeOptions& o) { o.motion.scale = -1; }));
  CHECK(refused([](LocalizeOptions& o) { o.match.gate = 0; }));
  CHECK(refused([](LocalizeOptions& o) { o.match.max_branches = 17; }));
  CHECK(refused([](LocalizeOptions& o) { o.search.min_scans = 0; }));
  CHECK(refused([&](LocalizeOptions& o) { o.search.lead = bad; }));
  CHECK(refused([](LocalizeOptions& o) { o.loss.scans = 0; }));
  CHECK(refused([](LocalizeOptions& o) { o.loss.on_wall_m = 0; }));
  CHECK(refused([&](LocalizeOptions& o) { o.start = Pose2{0, bad, 0}; }));
  CHECK(refused([](LocalizeOptions& o) { o.start_covariance[0] = -1; }));
  CHECK(refused([](LocalizeOptions& o) { o.start_covariance[1] = 0.01; }));
}

TEST_CASE("the same scans give the same bits, and a copy goes its own way") {
  Localizer a = localizer_in(crooked_room()), b = localizer_in(crooked_room());
  Drive drive_a(23), drive_b(23);
  for (int i = 0; i < 10; ++i) {
    drive_a.next(a);
    drive_b.next(b);
    REQUIRE(a.result().pose == b.result().pose);
    REQUIRE(a.result().covariance == b.result().covariance);
  }
  Localizer copy = a;
  Drive drive_copy = drive_a;
  const Pose2 before = a.result().pose;
  for (int i = 0; i < 10; ++i) drive_copy.next(copy);
  CHECK(a.result().pose == before);
  for (int i = 0; i < 10; ++i) drive_a.next(a);
  CHECK(a.result().pose == copy.result().pose);
  CHECK(a.result().covariance == copy.result().covariance);
}

TEST_CASE("every verdict and state has words") {
  for (int i = 0; i <= static_cast<int>(LineVerdict::no_pose); ++i)
    CHECK(std::string(to_string(static_cast<LineVerdict>(i))).find("unknown") == std::string::npos);
  for (int i = 0; i <= static_cast<int>(ScanVerdict::time_backwards); ++i)
    CHECK(std::string(to_string(static_cast<ScanVerdict>(i))).find("unknown") == std::string::npos);
  for (int i = 0; i <= static_cast<int>(LocalizeState::lost); ++i)
    CHECK(std::string(to_string(static_cast<LocalizeState>(i))).find("unknown") == std::string::npos);
}
