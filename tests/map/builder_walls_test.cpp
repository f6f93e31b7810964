// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "draw_plan.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;
using plan::Found;
using plan::Wall;

namespace {

constexpr Size size{200, 160};

/// A wall of this length through a place, at an angle.
Wall wall_at(Point2 centre, double angle, double length) {
  const double dx = std::cos(angle) * length / 2, dy = std::sin(angle) * length / 2;
  return {{centre.x - dx, centre.y - dy}, {centre.x + dx, centre.y + dy}};
}

/// The truth's offset by `aside` to the left of a to b in the drawing.
Wall moved(const Wall& wall, double aside) {
  const double dx = (wall.b.x - wall.a.x) / wall.length(), dy = (wall.b.y - wall.a.y) / wall.length();
  const Point2 by{-dy * aside, dx * aside};
  return {{wall.a.x + by.x, wall.a.y + by.y}, {wall.b.x + by.x, wall.b.y + by.y}};
}

}  // namespace

TEST_CASE("one thin wall becomes one axis with its width and ends") {
  for (const double width : {1.5, 2.0, 2.6, 3.2}) {
    for (int i = 0; i < 12; ++i) {
      const double angle = i * 15 * degree + 0.04 * (i % 3);
      CAPTURE(width, i);
      const Wall truth = wall_at({98.3 + 0.13 * i, 81.6 - 0.21 * i}, angle, 90);
      support::Canvas canvas(size);
      canvas.paint_bar(truth.a, truth.b, width);
      canvas.paint_box(4, 4, 12, 12);  // widths are told by what is black, and a thin wall alone may not be
      const std::vector<Found> found = plan::walls_in(canvas);
      REQUIRE(found.size() == 1);
      REQUIRE(found[0].line.width.has_value());
      CHECK(*found[0].line.width == Approx(width).margin(0.3));
      CHECK(plan::offset_error(found[0].wall, truth) < 0.15);
      CHECK(plan::angle_between(found[0].wall, truth) < 0.3 * degree);
      CHECK(plan::end_error(found[0].wall, truth) < 1);
      CHECK(found[0].line.free == FreeSide::both);
    }
  }
}

TEST_CASE("a thick wall keeps both faces where they are, each free on its light side") {
  for (const double width : {7.0, 10.4}) {
    for (int i = 0; i < 12; ++i) {
      const double angle = i * 15 * degree + 0.03 * (i % 4);
      CAPTURE(width, i);
      const Wall axis = wall_at({101.4, 78.7}, angle, 100);
      support::Canvas canvas(size);
      canvas.paint_bar(axis.a, axis.b, width);
      const std::vector<Found> found = plan::walls_in(canvas);
      for (const double side : {-0.5, 0.5}) {
        const Wall truth = moved(axis, side * width);
        const std::vector<Found> here = plan::beside(found, truth);
        REQUIRE(here.size() == 1);
        CHECK_FALSE(here[0].line.width.has_value());
        CHECK(plan::offset_error(here[0].wall, truth) < 0.15);
        CHECK(plan::end_error(here[0].wall, truth) < 1.2);
        const Point2 floor = plan::middle(moved(axis, side * (width + 10)));
        CHECK(here[0].line.free ==
              (plan::on_plus_side(here[0].line, floor, size) ? FreeSide::plus : FreeSide::minus));
      }
    }
  }
}

TEST_CASE("a thin light gap between two thick dark blocks is no wall") {
  for (const double gap : {2.0, 3.0}) {
    CAPTURE(gap);
    support::Canvas canvas(size);
    canvas.paint_box(40, 50, 160, 80 - gap / 2);
    canvas.paint_box(40, 80 + gap / 2, 160, 110);
    for (const Found& f : plan::walls_in(canvas)) CHECK_FALSE(f.line.width.has_value());
  }
}

TEST_CASE("a wall with a door is one line of two segments") {
  for (const double angle : {0.0, 0.4, 1.5707963267948966, -0.7}) {
    for (const double width : {2.4, 9.0}) {
      CAPTURE(angle, width);
      const Wall axis = wall_at({100, 80}, angle, 130);
      const Wall door = wall_at({100, 80}, angle, 30);
      support::Canvas canvas(size);
      canvas.paint_bar(axis.a, door.a, width);
      canvas.paint_bar(door.b, axis.b, width);
      const LineMap map = plan::build(canvas.picture()).map;
      const std::vector<Found> found = plan::found_in(map);
      for (const double side : {-0.5, 0.5}) {
        const double aside = width > 5 ? side * width : 0;
        for (const Wall& piece : {Wall{axis.a, door.a}, Wall{door.b, axis.b}}) {
          const std::vector<Found> here = plan::beside(found, moved(piece, aside));
          REQUIRE(here.size() == 1);
          CHECK(here[0].line.segments.size() == 2);
          CHECK(plan::end_error(here[0].wall, moved(piece, aside)) < 1.2);
        }
      }
    }
  }
}

TEST_CASE("short holes in a wall are bridged, long ones are not") {
  for (const double width : {2.4, 9.0}) {
    for (const double hole : {4.0, 16.0}) {
      CAPTURE(width, hole);
      support::Canvas canvas(size);
      canvas.paint_bar({30, 80}, {100 - hole / 2, 80}, width);
      canvas.paint_bar({100 + hole / 2, 80}, {170, 80}, width);
      const Wall truth = moved({{30, 80}, {170, 80}}, width > 5 ? width / 2 : 0);
      CHECK(plan::beside(plan::walls_in(canvas), truth).size() == (hole < 10 ? 1U : 2U));
    }
  }
}

TEST_CASE("a wall that meets another in its middle ends there") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 50}, {170, 50}, 2.4);
  canvas.paint_bar({100, 50}, {100, 130}, 2.4);
  const std::vector<Found> found = plan::walls_in(canvas);
  REQUIRE(found.size() == 2);
  const std::vector<Found> beam = plan::beside(found, {{30, 50}, {170, 50}});
  const std::vector<Found> post = plan::beside(found, {{100, 50}, {100, 130}});
  REQUIRE(beam.size() == 1);
  REQUIRE(post.size() == 1);
  CHECK(plan::end_error(beam[0].wall, {{30, 50}, {170, 50}}) < 1);
  CHECK(plan::end_error(post[0].wall, {{100, 50}, {100, 130}}) < 1);
}

TEST_CASE("a corner of thin walls is closed") {
  for (int turn = 0; turn < 6; ++turn) {
    CAPTURE(turn);
    const double angle = turn * 0.35;
    const Point2 corner{100.3, 79.6};
    const Point2 a{corner.x + 60 * std::cos(angle), corner.y + 60 * std::sin(angle)};
    const Point2 b{corner.x - 60 * std::sin(angle), corner.y + 60 * std::cos(angle)};
    support::Canvas canvas(size);
    canvas.paint_bar(corner, a, 2.4);
    canvas.paint_bar(corner, b, 2.4);
    const std::vector<Found> found = plan::walls_in(canvas);
    REQUIRE(found.size() == 2);
    for (const Found& f : found) {
      const auto from_corner = [&](Point2 p) { return std::hypot(p.x - corner.x, p.y - corner.y); };
      CHECK(std::fmin(from_corner(f.wall.a), from_corner(f.wall.b)) < 0.4);
    }
  }
}

TEST_CASE("a wall that runs into the picture's border goes to the border") {
  for (const double width : {2.4, 9.0}) {
    CAPTURE(width);
    support::Canvas canvas(size);
    canvas.paint_bar({-20, 80}, {120, 80}, width);
    const std::vector<Found> here =
        plan::beside(plan::walls_in(canvas), moved({{0, 80}, {120, 80}}, width > 5 ? width / 2 : 0));
    REQUIRE(here.size() == 1);
    CHECK(std::fmin(here[0].wall.a.x, here[0].wall.b.x) < 2.5);
    CHECK(std::fmin(here[0].wall.a.x, here[0].wall.b.x) > -0.5);
    CHECK(std::fmax(here[0].wall.a.x, here[0].wall.b.x) == Approx(120).margin(1.2));
  }
}

TEST_CASE("walls through the picture's centre and at the ends of theta's range keep the normal form") {
  for (int i = 0; i < 8; ++i) {
    for (const double aside : {0.0, 30.0, -30.0}) {
      CAPTURE(i, aside);
      const Wall truth = moved(wall_at({100, 80}, i * 22.5 * degree, 80), aside);
      support::Canvas canvas(size);
      canvas.paint_bar(truth.a, truth.b, 2.4);
      const std::vector<Found> found = plan::walls_in(canvas);  // checks the form
      REQUIRE(found.size() == 1);
      CHECK(found[0].line.rho == Approx(std::fabs(aside)).margin(0.15));
      CHECK(plan::offset_error(found[0].wall, truth) < 0.15);
    }
  }
}

TEST_CASE("small boxes that stand alone are furniture, long walls are not") {
  support::Canvas canvas(size);
  canvas.paint_box(30, 30, 45, 45);
  canvas.paint_box(60, 60, 160, 72);
  const LineMapResult result = plan::build(canvas.picture());
  const std::vector<Found> found = plan::found_in(result.map);
  CHECK(result.report.furniture > 0);
  REQUIRE_FALSE(found.empty());
  for (const Found& f : found) CHECK(f.wall.a.y > 50);
  CHECK(plan::beside(found, {{60, 60}, {160, 60}}).size() == 1);
  CHECK(plan::beside(found, {{60, 72}, {160, 72}}).size() == 1);
  LineMapOptions keep;
  keep.furniture_size = 0;
  std::size_t small = 0;
  for (const Found& f : plan::walls_in(canvas, keep)) small += f.wall.a.y < 50 ? 1 : 0;
  CHECK(small == 4);
}

TEST_CASE("shorter than min_length is dropped") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 40}, {170, 40}, 2.4);
  canvas.paint_bar({30, 100}, {60, 100}, 2.4);
  CHECK(plan::walls_in(canvas).size() == 2);
  LineMapOptions options;
  options.min_length = 50;
  const LineMapResult result = plan::build(canvas.picture(), options);
  CHECK(plan::found_in(result.map).size() == 1);
  CHECK(result.report.too_short >= 1);
}

TEST_CASE("max_wall_width divides axes from faces") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 80}, {170, 80}, 5);
  LineMapOptions options;
  options.max_wall_width = 6;
  const std::vector<Found> axis = plan::walls_in(canvas, options);
  REQUIRE(axis.size() == 1);
  REQUIRE(axis[0].line.width.has_value());
  CHECK(*axis[0].line.width == Approx(5).margin(0.3));
  options.max_wall_width = 3;
  const std::vector<Found> faces = plan::walls_in(canvas, options);
  CHECK(faces.size() == 2);
  for (const Found& f : faces) CHECK_FALSE(f.line.width.has_value());
}
