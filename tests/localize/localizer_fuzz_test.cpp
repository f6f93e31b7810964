// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/laser_run.hpp"

using namespace straightedge;
using namespace support;

namespace {

/// Numbers that real files have, and those that they should not have.
double any_number(Pcg32& random) {
  const double odd[] = {0,
                        -0.0,
                        1,
                        -1,
                        1e-300,
                        1e-9,
                        1e9,
                        -1e9,
                        1e300,
                        5e-324,
                        3.14159265,
                        std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  return random.below(3) == 0 ? odd[random.below(13)] : uniform(random, -10, 10);
}

float any_range(Pcg32& random) {
  if (random.below(20) == 0) return static_cast<float>(std::fmod(any_number(random), 1e38));
  return static_cast<float>(uniform(random, 0.1, 12));
}

LaserScan any_scan(Pcg32& random) {
  LaserScan scan;
  scan.angle_step_rad = random.below(4) == 0 ? any_number(random) : uniform(random, -0.05, 0.05);
  scan.first_angle_rad = random.below(8) == 0 ? any_number(random) : uniform(random, -4, 4);
  scan.max_range_m = random.below(4) == 0 ? any_number(random) : 0;
  if (random.below(8) == 0)
    scan.laser_in_robot = {any_number(random), any_number(random), any_number(random)};
  scan.ranges_m.resize(random.below(400));
  for (float& range : scan.ranges_m) range = any_range(random);
  return scan;
}

}  // namespace

TEST_CASE("no scan and no odometry break a localizer; what it says of its pose is a pose") {
  const Room room = crooked_room();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Pcg32 random(seed);
    LocalizeOptions options;
    options.lines.method = static_cast<ScanLineMethod>(seed % 3);
    options.match.association = seed % 2 == 0 ? Association::nearest : Association::joint;
    if (seed % 4 != 0) options.start = on_the_way(0);
    auto localizer = Localizer::create(map_of(room), options);
    REQUIRE(localizer);
    for (int i = 0; i < 60; ++i) {
      CAPTURE(seed, i);
      LaserScan scan = random.below(3) == 0 ? exact_scan(room, on_the_way(i)) : any_scan(random);
      scan.time_s = random.below(20) == 0 ? any_number(random) : i;
      std::optional<Pose2> odometry;
      if (random.below(3) != 0) odometry = Pose2{any_number(random), any_number(random), any_number(random)};
      const LocalizeResult& result = localizer->step(scan, odometry);
      REQUIRE(result.lines.size() == result.matches.size());
      if (!result.has_pose) continue;
      REQUIRE(usable(result.pose));
      for (const std::size_t k : {0U, 4U, 8U}) REQUIRE(result.covariance[k] >= 0);
    }
  }
}
