// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/line_pair.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/laser_room.hpp"

using namespace straightedge;
using namespace straightedge::localize;
using namespace support;

namespace {

const Room slanted{{{2, -3}, {5, 4}}};
const Pose2 robot{0.4, 0.3, 0.2};
constexpr double step = 1e-6;

ScanLine seen_line() {
  auto finder = ScanLineFinder::create();
  REQUIRE(finder);
  REQUIRE(finder->run(exact_scan(slanted, robot)));
  REQUIRE(finder->lines().size() == 1);
  return finder->lines()[0];
}

/// The wall, its line turned and shifted about the point of its covariance.
WallMap wrong_map(double turn, double shift) {
  LineMap map = map_of(slanted);
  MapLine& line = map.lines[0];
  const LineCovariance at = *line.covariance;
  line.theta += turn;
  const Point2 normal = line_normal(line.theta);
  line.rho = at.at_x * normal.x + at.at_y * normal.y + shift;
  return WallMap(map, {});
}

}  // namespace

TEST_CASE("both errors are zero at the true pose") {
  const LinePair pair = make_pair(robot, seen_line(), 0, wrong_map(0, 0), 0);
  CHECK(pair.angle == Approx(0).margin(1e-6));
  CHECK(pair.offset == Approx(0).margin(1e-6));
}

TEST_CASE("the derivatives are those of small steps") {
  const WallMap map = wrong_map(0, 0);
  const ScanLine line = seen_line();
  // A pose and a wall at which nothing is zero by chance; the laser sees a part of the wall: the lever is
  // long.
  const Pose2 pose{1, -0.5, 0.35};
  const LinePair pair = make_pair(pose, line, 0, map, 0);
  REQUIRE(std::fabs(pair.lever) > 0.3);
  const Matrix<2, state_size> h = by_state(pair, map.walls()[0]);
  for (std::size_t i = 0; i < state_size; ++i) {
    CAPTURE(i);
    const Pose2 moved{pose.x_m + (i == 0 ? step : 0), pose.y_m + (i == 1 ? step : 0),
                      pose.heading_rad + (i == 2 ? step : 0)};
    const LinePair there = make_pair(moved, line, 0, map, 0);
    CHECK(h(0, i) == Approx((there.angle - pair.angle) / step).margin(1e-4));
    CHECK(h(1, i) == Approx((there.offset - pair.offset) / step).margin(1e-4));
  }
  const Matrix2 j = by_wall(pair);
  const LinePair turned = make_pair(pose, line, 0, wrong_map(step, 0), 0);
  const LinePair shifted = make_pair(pose, line, 0, wrong_map(0, step), 0);
  CHECK(j(0, 0) == Approx((turned.angle - pair.angle) / step).margin(1e-4));
  CHECK(j(1, 0) == Approx((turned.offset - pair.offset) / step).margin(1e-4));
  CHECK(j(0, 1) == Approx((shifted.angle - pair.angle) / step).margin(1e-4));
  CHECK(j(1, 1) == Approx((shifted.offset - pair.offset) / step).margin(1e-4));
}

TEST_CASE("a correction is that of the textbook, for a map without errors") {
  LineMap exact = map_of(slanted, 0, 0);
  MatchOptions options;
  options.wall_angle_floor_rad = 0;
  options.wall_offset_floor_m = 0;
  const WallMap map(exact, options);
  const ScanLine line = seen_line();
  PoseBelief belief = belief_at({0.5, 0.2, 0.25}, {{0.04, 0.01, 0, 0.01, 0.09, 0.002, 0, 0.002, 0.01}}, {});
  LinePair pair = make_pair(belief.pose, line, 0, map, 0);
  REQUIRE(judge_pair(pair, belief, map.walls()[0]));
  // In information form: P⁻¹ grows by Hᵀ R⁻¹ H. Checked by P' (P⁻¹ + Hᵀ R⁻¹ H) P = P.
  const auto h = by_state(pair, map.walls()[0]);
  const StateMatrix before = belief.covariance;
  correct(belief, pair, map);
  const Matrix2 information{{1 / pair.var_theta, 0, 0, 1 / pair.var_offset}};
  const StateMatrix again =
      belief.covariance + belief.covariance * (transposed(h) * information * h) * before;
  for (std::size_t i = 0; i < again.v.size(); ++i) CHECK(again.v[i] == Approx(before.v[i]).margin(1e-9));
}

TEST_CASE("a second sight of a wall with errors brings less than the first") {
  const WallMap map(map_of(slanted, 0.01, 0.05), {});
  const ScanLine line = seen_line();
  PoseBelief belief = belief_at(robot, {{0.25, 0, 0, 0, 0.25, 0, 0, 0, 0.04}}, {});
  const auto across = [&] {
    const Wall& wall = map.walls()[0];
    const auto& p = belief.covariance;
    return wall.nx * wall.nx * p(0, 0) + 2 * wall.nx * wall.ny * p(0, 1) + wall.ny * wall.ny * p(1, 1);
  };
  for (int i = 0; i < 300; ++i) {
    LinePair pair = make_pair(belief.pose, line, 0, map, 0);
    REQUIRE(judge_pair(pair, belief, map.walls()[0]));
    CHECK(pair.chi_square < 1);
    correct(belief, pair, map);
    CHECK(across() > 0.05 * 0.05);
  }
  // Where the robot is from that wall is known well, wherever the wall is: the gate is narrow.
  LinePair pair = make_pair(belief.pose, line, 0, map, 0);
  REQUIRE(judge_pair(pair, belief, map.walls()[0]));
  CHECK(pair.s(1, 1) < 0.03 * 0.03);
  CHECK(pair.s(0, 0) < 0.01 * 0.01);
}
