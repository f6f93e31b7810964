// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/corners.hpp"

#include <cmath>

#include "stage_lines.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;
using stage::face;

TEST_CASE("ends that all but meet move to the crossing") {
  std::vector<WallLine> lines{face({12, 20}, {80, 20}), face({10, 22.5}, {10, 70})};
  close_corners(lines, {}, 3.5);
  stage::check_ends(lines[0], {10, 20}, {80, 20}, 1e-6);
  stage::check_ends(lines[1], {10, 20}, {10, 70}, 1e-6);
}

TEST_CASE("ends that stick out are taken back to the crossing") {
  std::vector<WallLine> lines{face({8, 20}, {80, 20}), face({10, 18.5}, {10, 70})};
  close_corners(lines, {}, 3.5);
  stage::check_ends(lines[0], {10, 20}, {80, 20}, 1e-6);
  stage::check_ends(lines[1], {10, 20}, {10, 70}, 1e-6);
}

TEST_CASE("a wall that stops short of another's middle goes up to it; the other stays") {
  std::vector<WallLine> lines{face({10, 20}, {80, 20}), face({40, 22}, {40, 70})};
  close_corners(lines, {}, 3.5);
  stage::check_ends(lines[0], {10, 20}, {80, 20}, 1e-6);
  stage::check_ends(lines[1], {40, 20}, {40, 70}, 1e-6);
}

TEST_CASE("beyond reach, nearly parallel or not that far along, nothing moves") {
  for (const WallLine& other :
       {face({10, 25}, {10, 70}), face({85, 20}, {150, 35}), face({6, 60}, {6, 24})}) {
    std::vector<WallLine> lines{face({10, 20}, {80, 20}), other};
    close_corners(lines, {}, 3.5);
    stage::check_ends(lines[0], {10, 20}, {80, 20}, 1e-6);
    stage::check_ends(lines[1], stage::begin_of(other), stage::end_of(other), 1e-6);
  }
}

TEST_CASE("the nearest crossing counts, also one with a helper") {
  std::vector<WallLine> lines{face({12, 20}, {80, 20}), face({9, 20}, {9, 70})};
  close_corners(lines, {face({11, 17}, {11, 23})}, 3.5);
  stage::check_ends(lines[0], {11, 20}, {80, 20}, 1e-6);
}

TEST_CASE("20 degrees is where corners begin") {
  for (const double degrees : {18.0, 22.0}) {
    CAPTURE(degrees);
    const double c = std::cos(degrees * degree), s = std::sin(degrees * degree);
    std::vector<WallLine> lines{face({12, 20}, {80, 20}),
                                face({10 + 1 * c, 20 + 1 * s}, {10 + 60 * c, 20 + 60 * s})};
    close_corners(lines, {}, 3.5);
    CHECK(stage::begin_of(lines[0]).x == Approx(degrees < 20 ? 12 : 10).margin(1e-6));
  }
}

TEST_CASE("no lines, no corners") {
  std::vector<WallLine> none;
  close_corners(none, {}, 3.5);
  CHECK(none.empty());
}
