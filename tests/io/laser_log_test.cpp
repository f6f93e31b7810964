// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/laser_log.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "catch.hpp"
#include "straightedge/trigonometry.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

LaserLog log_of(const std::string& text) {
  auto log = laser_log_from_bytes(text, "log");
  INFO(text);
  if (!log) FAIL(log.failure().sentence);
  return std::move(*log);
}

std::string refusal_of(const std::string& text) {
  const auto log = laser_log_from_bytes(text, "log");
  INFO(text.substr(0, 200));
  REQUIRE_FALSE(log);
  CHECK(log.failure().problem == Problem::bad_content);
  REQUIRE(log.failure().sentence.starts_with("log: "));
  return log.failure().sentence.substr(5);
}

/// Where a scan's beam i points.
double angle_of(const LaserScan& scan, std::size_t i) {
  return scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
}

const std::string scan_3 = "SCAN 1 0 0 0 2 1 80 3 1 2 3\n";

std::string flaser(const std::string& count_and_ranges, const std::string& time = "5") {
  return "FLASER " + count_and_ranges + " 1 2 0.5 1.5 2.5 0.25 " + time + " host 7\n";
}

}  // namespace

TEST_CASE("the plain format: scans, the laser's place, the odometry before each scan") {
  const LaserLog log = log_of(
      "# a comment\r\n\r\n"
      "SCAN 10.5 0.2 -0.1 1.5 3 1 80 4 1.5 0 nan inf # of the beams\r\n"
      "ODOM 0 1 2 3\r\n"
      "ODOM 4 5 6 7.25\r\n"
      "SCAN 10.5 0 0 0 2 0 0 3 -1 1e300 2\r\n");
  CHECK(log.format == LaserLogFormat::text);
  CHECK(log.late_scans == 0);
  REQUIRE(log.scans.size() == 2);
  const LaserScan& first = log.scans[0].scan;
  CHECK(first.time_s == 10.5);
  CHECK(first.laser_in_robot == Pose2{0.2, -0.1, 1.5});
  CHECK(first.max_range_m == 80);
  CHECK_FALSE(log.scans[0].odometry);
  CHECK_FALSE(log.scans[0].recorded);
  CHECK(log.scans[0].line == 3);
  REQUIRE(first.ranges_m.size() == 4);
  CHECK(first.ranges_m[0] == 1.5F);
  CHECK(first.ranges_m[1] == 0);
  CHECK(std::isnan(first.ranges_m[2]));
  CHECK(std::isinf(first.ranges_m[3]));
  CHECK(angle_of(first, 0) == Approx(-1.5));
  CHECK(angle_of(first, 3) == Approx(1.5));
  const LaserScan& second = log.scans[1].scan;
  CHECK(log.scans[1].odometry == Pose2{5, 6, 7.25});
  CHECK(log.scans[1].line == 6);
  CHECK(angle_of(second, 0) == Approx(1));  // left to right
  CHECK(angle_of(second, 2) == Approx(-1));
  CHECK(std::isinf(second.ranges_m[1]));
}

TEST_CASE("CARMEN's beams begin at the right and spread as their number says") {
  const LaserLog log =
      log_of("PARAM a b c\nODOM 1 2 3 0 0 0 4 host 4\n" + flaser("2 1 2") + flaser("3 1 2 3", "6") +
             "RLASER 1 nonsense\n" + flaser("1 4", "6") + flaser("0", "7"));
  CHECK(log.format == LaserLogFormat::carmen);
  REQUIRE(log.scans.size() == 4);
  const LoggedScan& even = log.scans[0];
  CHECK(even.odometry == Pose2{1, 2, 3});
  CHECK(even.recorded == Pose2{1, 2, 0.5});
  CHECK(even.scan.time_s == 5);
  CHECK(even.scan.max_range_m == 80);
  CHECK(even.scan.laser_in_robot == Pose2{});
  CHECK(angle_of(even.scan, 0) == Approx(-pi / 2));
  CHECK(angle_of(even.scan, 1) == Approx(0).margin(1e-15));
  CHECK(angle_of(log.scans[1].scan, 2) == Approx(pi / 2));
  CHECK(log.scans[2].scan.angle_step_rad > 0);
  CHECK(log.scans[3].scan.ranges_m.empty());
  CHECK(log.scans[3].scan.angle_step_rad > 0);
  // Old logs do not name the computer.
  CHECK(log_of("FLASER 1 2 0 0 0 0 0 0 9\n").scans[0].scan.time_s == 9);
}

TEST_CASE("CARMEN's clocks differ: a scan that is a little late is left out, a jump is refused") {
  const LaserLog log = log_of(flaser("1 1", "5") + flaser("1 2", "4.5") + flaser("1 3", "5"));
  CHECK(log.late_scans == 1);
  REQUIRE(log.scans.size() == 2);
  CHECK(log.scans[1].scan.ranges_m[0] == 3);
  CHECK(refusal_of(flaser("1 1", "5") + flaser("1 2", "4")) ==
        "line 2: time 4 comes after 5: times must not run backwards");
}

TEST_CASE("scans may differ in size; one beam points ahead") {
  const LaserLog log = log_of(scan_3 + "SCAN 2 0 0 0 2 1 80 0\nSCAN 2 0 0 0 2 0 80 1 5\n");
  REQUIRE(log.scans.size() == 3);
  CHECK(log.scans[1].scan.ranges_m.empty());
  CHECK(log.scans[2].scan.first_angle_rad == 0);
  CHECK(log.scans[2].scan.angle_step_rad != 0);
  // Four beams of a circle, the last of which is not the first again.
  CHECK(angle_of(log_of("SCAN 1 0 0 0 4.71238898038469 1 80 4 1 2 3 4").scans[0].scan, 1) == Approx(-pi / 4));
}

TEST_CASE("the shipped runs") {
  const auto simulated = read_laser_log(STRAIGHTEDGE_FIXTURES "/laser2d/mrpt_simul/scans.txt.gz");
  REQUIRE(simulated);
  CHECK(simulated->scans.size() == 1733);
  CHECK_FALSE(simulated->scans[0].odometry);
  CHECK(simulated->scans[1].odometry == Pose2{-0.007262, -0.009358, 0.00079273});
  for (const LoggedScan& logged : simulated->scans) {
    REQUIRE(logged.scan.ranges_m.size() == 361);
    REQUIRE(logged.scan.laser_in_robot == Pose2{0.2, 0, 0});
  }
  const auto corridor = read_laser_log(STRAIGHTEDGE_FIXTURES "/laser2d/mrpt_corridor/scans.txt.gz");
  REQUIRE(corridor);
  CHECK(corridor->scans.size() == 37);
  CHECK(corridor->scans[0].odometry == Pose2{0.247794, 0.018789, 0.14207423});
}

TEST_CASE("broken records are refused with their line") {
  CHECK(refusal_of(scan_3 + "SCAN 2 0 0 0 2 1 80 3 1 2\n") == "line 2: the record ends before its range");
  CHECK(refusal_of("SCAN 2 0 0 0 2 1 80 3 1 2 3 4") == "line 1: more words follow the last range");
  CHECK(refusal_of("SCAN") == "line 1: the record ends before its time");
  CHECK(refusal_of("SCAN 1 0 0") == "line 1: the record ends before its sensor's pose");
  CHECK(refusal_of("SCAN nan 0 0 0 2 1 80 1 1") == "line 1: time is not finite");
  CHECK(refusal_of("SCAN x 0 0 0 2 1 80 1 1") == "line 1: time 'x' is no number");
  CHECK(refusal_of("SCAN 1 0 0 0 2 1 80 3 1 2,5 3") == "line 1: range '2,5' is no number");
  CHECK(refusal_of("SCAN 1 inf 0 0 2 1 80 1 1") == "line 1: sensor's pose is not finite");
  CHECK(refusal_of("SCAN 1 1e9 0 0 2 1 80 1 1") == "line 1: sensor's pose lies too far out");
  CHECK(refusal_of("SCAN 1 0 0 0 2 2 80 1 1") == "line 1: right_to_left is '2' and not 0 or 1");
  CHECK(refusal_of("SCAN 1 0 0 0 2 1 -1 1 1") == "line 1: max_range is below 0");
  for (const char* aperture : {"0", "-1", "6.4", "1e308"})
    CHECK(refusal_of("SCAN 1 0 0 0 " + std::string(aperture) + " 1 80 1 1")
              .starts_with("line 1: the aperture is"));
  for (const char* count : {"nan", "-1", "2.5", "1e3", "65537", "99999999999999999999", "\x1b[31m"})
    CHECK(refusal_of("SCAN 1 0 0 0 2 1 80 " + std::string(count) + " 1 2 3")
              .starts_with("line 1: the number of beams is '"));
  CHECK(refusal_of(scan_3 + "ODOM 1 2 3\n") == "line 2: the record ends before its odometry");
  CHECK(refusal_of(scan_3 + "ODOM 1 2 3 4 5\n") == "line 2: more words follow the odometry's angle");
  CHECK(refusal_of(scan_3 + "scan 1 2\n") == "line 2: 'scan' is no record of a laser log (ODOM, SCAN)");
  CHECK(refusal_of(scan_3 + "SCAN 0.5 0 0 0 2 1 80 1 1\n") ==
        "line 2: time 0.5 comes after 1: times must not run backwards");
}

TEST_CASE("broken CARMEN records are refused with their line") {
  CHECK(refusal_of("FLASER 3 1 2 3 4") == "line 1: the record ends before its laser's pose");
  CHECK(refusal_of("FLASER 1 1 0 0 0 0 0 0") == "line 1: the record ends before its time");
  CHECK(refusal_of("FLASER 1 1 0 0 0 0 0 0 1 h 2 3") == "line 1: more words follow the logger's time");
  CHECK(refusal_of("FLASER -1 0 0 0 0 0 0 1").starts_with("line 1: the number of beams is '-1'"));
  CHECK(refusal_of("FLASER 1 1 0 nan 0 0 0 0 1 h 2") == "line 1: laser's pose is not finite");
  CHECK(refusal_of(flaser("1 1") + "ODOM 1 2 3\n") == "line 2: the record ends before its tv");
  CHECK(refusal_of(flaser("1 1") + "ODOM 1 2 x 0 0 0 1\n") == "line 2: odometry 'x' is no number");
}

TEST_CASE("what is no laser log at all is refused") {
  const std::string none = "holds no laser scan (no line begins with SCAN or FLASER)";
  CHECK(refusal_of("") == none);
  CHECK(refusal_of("\n\n# SCAN\n") == none);
  CHECK(refusal_of("ODOM 1 2 3 4\n") == none);
  CHECK(refusal_of(std::string("\x89PNG\r\n\x1A\n\0\0\0", 11)) == none);
  CHECK(refusal_of(std::string(100000, '\0')) == none);
  const auto missing = read_laser_log("/nonexistent/scans.txt");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
  const TemporaryFolder folder;
  const auto is_folder = read_laser_log(folder.path());
  REQUIRE_FALSE(is_folder);
  CHECK(is_folder.failure().problem == Problem::cannot_read);
}
