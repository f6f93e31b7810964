// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>
#include <string>

#include "catch.hpp"
#include "gzip_maker.hpp"
#include "mutated.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/planar_trajectory.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

constexpr std::uint32_t seed = 67;

const std::string plain =
    "# c\nODOM 0 1 2 3\nSCAN 1 0.2 0 0 3.14 1 80 5 1 2 0 nan 5\nODOM 1.5 1 2 3\nSCAN 2 0 0 0 6 0 0 3 1 2 3\n";
const std::string carmen =
    "PARAM x 1\nODOM 1 2 3 0 0 0 4 h 4\nFLASER 4 1 2 81.91 4 1 2 3 1 2 3 5 h 5\nNEFF 3\n"
    "FLASER 3 1 2 3 1 2 3 1 2 3 5.5 h 5.5\n";

void check_usable(const LaserLog& log) {
  REQUIRE_FALSE(log.scans.empty());
  double time = log.scans[0].scan.time_s;
  for (const LoggedScan& logged : log.scans) {
    const LaserScan& scan = logged.scan;
    REQUIRE(std::isfinite(scan.first_angle_rad));
    REQUIRE(std::abs(scan.angle_step_rad) > 0);
    REQUIRE(std::isfinite(scan.angle_step_rad));
    REQUIRE(scan.max_range_m >= 0);
    REQUIRE(scan.time_s >= time);
    REQUIRE(scan.ranges_m.size() <= max_scan_beams);
    REQUIRE(usable(scan.laser_in_robot));
    if (logged.odometry) REQUIRE(usable(*logged.odometry));
    time = scan.time_s;
  }
}

}  // namespace

TEST_CASE("mutated laser logs are read or refused") {
  std::mt19937 generator(seed);
  const std::string files[] = {plain, carmen, gzip_maker::packed(plain), gzip_maker::packed(carmen)};
  int read = 0;
  for (int round = 0; round < 8000; ++round) {
    std::string bytes = mutated(files[round % 4], generator);
    if (round % 8 == 7) bytes = gzip_maker::packed(mutated(carmen, generator));
    const auto log = laser_log_from_bytes(bytes, "x");
    INFO("seed " << seed << ", round " << round);
    if (!log) {
      expect_sentence(log.failure(), seed, round);
      continue;
    }
    ++read;
    check_usable(*log);
  }
  CHECK(read > 500);
}

TEST_CASE("mutated truths are read or refused") {
  std::mt19937 generator(seed);
  const TemporaryFolder folder;
  const std::string files[] = {"# t\n1 2 3 4\n2 3 4 5\n", "1 2 3 0 0 0 0.6 0.8\n2 2 3 0 0 0 0 1\n"};
  for (int round = 0; round < 3000; ++round) {
    const auto poses = read_planar_trajectory(folder.put("t.txt", mutated(files[round % 2], generator)));
    if (!poses) {
      expect_sentence(poses.failure(), seed, round);
      continue;
    }
    INFO("seed " << seed << ", round " << round);
    for (const TimedPose2& timed : *poses) REQUIRE(usable(timed.pose));
  }
}
