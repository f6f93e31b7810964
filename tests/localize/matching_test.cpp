// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "localize/match.hpp"
#include "support/catch.hpp"
#include "support/laser_room.hpp"

using namespace straightedge;
using namespace straightedge::localize;
using namespace support;

namespace {

struct Outcome {
  std::vector<ScanLine> lines;
  std::vector<LineMatch> matches;
  PoseBelief belief;
};

PoseBelief belief_about(const Pose2& pose, double sigma_m, double sigma_rad) {
  const double way = sigma_m * sigma_m;
  return belief_at(pose, {{way, 0, 0, 0, way, 0, 0, 0, sigma_rad * sigma_rad}}, {});
}

/// A robot that stands at `truth` and believes in `belief` matches what it sees of `seen` with `map`.
Outcome match(const Room& seen, const Room& map, const Pose2& truth, const PoseBelief& belief,
              const MatchOptions& options = {}) {
  auto finder = ScanLineFinder::create();
  REQUIRE(finder);
  REQUIRE(finder->run(exact_scan(seen, truth)));
  Outcome outcome{finder->lines(), {}, belief};
  const WallMap walls(map_of(map), options);
  Matcher().match_and_correct(walls, outcome.lines, options, outcome.belief, outcome.matches);
  REQUIRE(outcome.matches.size() == outcome.lines.size());
  return outcome;
}

LineVerdict only_verdict(const Outcome& outcome) {
  REQUIRE(outcome.matches.size() == 1);
  return outcome.matches[0].verdict;
}

const Room ahead{{{3, -2}, {3, 2}}};

Room moved(const Room& room, double x, double y) {
  Room out = room;
  for (RoomWall& wall : out) {
    wall.a = {wall.a.x + x, wall.a.y + y};
    wall.b = {wall.b.x + x, wall.b.y + y};
  }
  return out;
}

double error(const PoseBelief& belief, const Pose2& truth) {
  return std::hypot(belief.pose.x_m - truth.x_m, belief.pose.y_m - truth.y_m);
}

}  // namespace

TEST_CASE("the wall itself is matched, and corrects what it shows") {
  const Outcome outcome = match(ahead, ahead, {}, belief_about({0.2, 0.1, 0.02}, 0.3, 0.05));
  CHECK(only_verdict(outcome) == LineVerdict::matched);
  CHECK(outcome.matches[0].line_id == 100);
  CHECK(outcome.matches[0].segment_id == 200);
  CHECK(outcome.belief.pose.x_m == Approx(0).margin(0.01));
  CHECK(outcome.belief.pose.y_m == Approx(0.1).margin(0.02));  // nothing is seen of the way along the wall
  CHECK(outcome.belief.pose.heading_rad == Approx(0).margin(0.003));
  CHECK(outcome.belief.covariance(0, 0) < 0.04 * 0.04);
  CHECK(outcome.belief.covariance(1, 1) > 0.25 * 0.25);
}

TEST_CASE("no wall near in angle and distance") {
  CHECK(only_verdict(match(ahead, moved(ahead, 3, 0), {}, belief_about({}, 0.3, 0.05))) ==
        LineVerdict::no_wall);
  CHECK(only_verdict(match(ahead, {{{1, 0}, {5, 2}}}, {}, belief_about({}, 0.3, 0.05))) ==
        LineVerdict::no_wall);
}

TEST_CASE("a wall whose floor is on the other side is another wall") {
  Room room = ahead;  // its normal is (1, 0): the robot stands on the minus side
  room[0].free = FreeSide::plus;
  CHECK(only_verdict(match(room, room, {}, belief_about({}, 0.3, 0.05))) == LineVerdict::wrong_side);
  room[0].free = FreeSide::minus;
  CHECK(only_verdict(match(room, room, {}, belief_about({}, 0.3, 0.05))) == LineVerdict::matched);
  room[0].free = FreeSide::both;
  CHECK(only_verdict(match(room, room, {}, belief_about({}, 0.3, 0.05))) == LineVerdict::matched);
}

TEST_CASE("a wall that ends before the line") {
  CHECK(only_verdict(match(ahead, moved(ahead, 0, 4.5), {}, belief_about({}, 0.05, 0.05))) ==
        LineVerdict::no_overlap);
  // The less the robot knows of where it is along the wall, the farther it may end.
  CHECK(only_verdict(match(ahead, moved(ahead, 0, 2.6), {}, belief_about({}, 0.05, 0.05))) ==
        LineVerdict::no_overlap);
  CHECK(only_verdict(match(ahead, moved(ahead, 0, 2.6), {}, belief_about({}, 0.5, 0.05))) ==
        LineVerdict::matched);
}

TEST_CASE("farther off than both covariances allow") {
  const Outcome refused = match(ahead, moved(ahead, 0.5, 0), {}, belief_about({}, 0.05, 0.01));
  CHECK(only_verdict(refused) == LineVerdict::gate);
  CHECK(refused.matches[0].chi_square > 9.21);
  CHECK(refused.matches[0].line_id == 100);
  CHECK(refused.belief.pose == Pose2{});
  CHECK(only_verdict(match(ahead, moved(ahead, 0.5, 0), {}, belief_about({}, 0.3, 0.01))) ==
        LineVerdict::matched);
}

TEST_CASE("a lone wall is not trusted when it may be another") {
  // Two parallel walls half a metre apart, one of them seen, the pose as uncertain as that.
  const Room two{{{3, -2}, {3, 2}}, {{3.5, -2}, {3.5, 2}}};
  for (const Association association : {Association::joint, Association::nearest}) {
    MatchOptions options;
    options.association = association;
    const PoseBelief before = belief_about({0.2, 0, 0}, 0.4, 0.02);
    const Outcome outcome = match(ahead, two, {}, before, options);
    CHECK(only_verdict(outcome) == LineVerdict::ambiguous);
    CHECK(outcome.belief.pose == before.pose);
    // A robot that knows where it is has no doubt.
    CHECK(only_verdict(match(ahead, two, {}, belief_about({0.02, 0, 0}, 0.05, 0.02), options)) ==
          LineVerdict::matched);
  }
}

TEST_CASE("two walls together tell which two they are") {
  // Walls ahead and behind, and copies of both half a metre farther: their distance decides.
  const Room seen{{{3, -2}, {3, 2}}, {{-2, 3}, {2.5, 3}}, {{-2, -3}, {2.5, -3}}};
  Room map = seen;
  map.push_back({{-2, 3.6}, {2.5, 3.6}});
  map.push_back({{-2, -2.5}, {2.5, -2.5}});
  map.push_back({{3.45, -2}, {3.45, 2}});
  map.push_back({{3.45, 2}, {4.1, 2}});
  const Outcome outcome = match(seen, map, {}, belief_about({0, 0.28, 0}, 0.35, 0.02));
  REQUIRE(outcome.matches.size() == 3);
  int matched = 0;
  for (const LineMatch& m : outcome.matches) {
    if (m.verdict != LineVerdict::matched) continue;
    CHECK(m.line_id != 103);
    CHECK(m.line_id != 104);
    ++matched;
  }
  CHECK(matched >= 2);
  CHECK(std::fabs(outcome.belief.pose.y_m) < 0.03);
}

TEST_CASE("a pair that fits alone but not with the others is left out") {
  const Room seen{{{3, -2}, {3, 2}}, {{-2, 3}, {2.5, 3}}, {{-2, -3}, {2.5, -3}}};
  Room map = seen;
  map[2] = {{-2, -3.4}, {2.5, -3.4}};  // moved since the map was made
  const Outcome outcome = match(seen, map, {}, belief_about({0, 0, 0}, 0.4, 0.02));
  REQUIRE(outcome.matches.size() == 3);
  int left_out = 0;
  for (const LineMatch& m : outcome.matches) left_out += m.verdict == LineVerdict::not_joint;
  CHECK(left_out == 1);
  CHECK((std::fabs(outcome.belief.pose.y_m) < 0.05 || std::fabs(outcome.belief.pose.y_m - 0.4) < 0.05));
}

TEST_CASE("no lines, no walls near: the belief stays") {
  const PoseBelief before = belief_about({50, 50, 1}, 0.3, 0.05);
  const Outcome outcome = match(ahead, ahead, {}, before);
  CHECK(outcome.belief.pose == before.pose);
  CHECK(only_verdict(outcome) == LineVerdict::no_wall);
  CHECK(match({}, ahead, {}, before).matches.empty());
}

TEST_CASE("in a room every line finds its wall, from a pose that is off") {
  const Room room = crooked_room();
  for (int step = 0; step < 200; step += 10) {
    const Pose2 truth = on_the_way(step);
    Pose2 off = truth;
    off.x_m += 0.15;
    off.y_m -= 0.1;
    off.heading_rad += 0.05;
    const Outcome outcome = match(room, room, truth, belief_about(off, 0.2, 0.08));
    CAPTURE(step);
    for (const LineMatch& m : outcome.matches) CHECK(m.verdict == LineVerdict::matched);
    CHECK(error(outcome.belief, truth) < 0.02);
  }
}
