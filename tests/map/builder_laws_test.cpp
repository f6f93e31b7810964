// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>

#include "draw_plan.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;
using plan::Found;
using plan::Wall;

namespace {

constexpr Size size{180, 150};

/// Thin and thick walls, doors and a corner, at an angle, away from the border.
support::Canvas rooms(double angle) {
  support::Canvas canvas(size, 254);
  const auto at = [&](double x, double y) {
    return Point2{90 + x * std::cos(angle) - y * std::sin(angle),
                  75 + x * std::sin(angle) + y * std::cos(angle)};
  };
  canvas.paint_bar(at(-50, -40), at(50, -40), 2.4);
  canvas.paint_bar(at(50, -41.2), at(50, 20), 2.4);
  canvas.paint_bar(at(-50, -15), at(-10, -15), 1.8);
  canvas.paint_bar(at(12, -15), at(48.8, -15), 1.8);
  canvas.paint_bar(at(-45, 25), at(20, 25), 9);
  return canvas;
}

std::vector<Found> walls_in(const Image<std::uint8_t>& picture, const LineMapOptions& options) {
  return plan::found_in(plan::build(picture, options).map);
}

using Move = std::function<Point2(Point2)>;

/// Each of the first has one of the second at the place to which it moves, and the other way round.
void check_moved(const std::vector<Found>& before, const std::vector<Found>& after, const Move& move,
                 double across, double ends) {
  CHECK(before.size() == after.size());
  for (const Found& f : before) {
    const Wall expected{move(f.wall.a), move(f.wall.b)};
    CAPTURE(expected.a.x, expected.a.y, expected.b.x, expected.b.y);
    const auto match = std::find_if(after.begin(), after.end(), [&](const Found& g) {
      return plan::end_error(g.wall, expected) <= ends && plan::offset_error(g.wall, expected) <= across &&
             f.line.width.has_value() == g.line.width.has_value();
    });
    CHECK(match != after.end());
  }
}

/// The ends of the thick wall are 9 pixels long: just so a line, or none, if 9 are asked for.
LineMapOptions followed_or_voted() {
  LineMapOptions options{.min_length = 12};
  if (GENERATE(true, false)) options.hough = line_map_hough;
  return options;
}

const double angles[] = {0, 0.21, 0.7853981633974483, 1.2};

}  // namespace

// Away from the border and with other things equal, a shift by whole pixels changes no gray value that is
// looked at. Other pixels of an edge are seeds from which it is followed, or are drawn first by the Hough
// transform; refinement takes this back but for the places of a few pixels.
TEST_CASE("a shifted picture has shifted lines") {
  const LineMapOptions options = followed_or_voted();
  for (const double angle : angles) {
    const Image<std::uint8_t> picture = rooms(angle).picture();
    const auto here = walls_in(support::placed(picture, {240, 210}, 20, 20, 254), options);
    REQUIRE(here.size() >= 6);
    for (const auto& [left, top] : {std::pair{21, 20}, std::pair{37, 48}, std::pair{3, 5}}) {
      CAPTURE(angle, left, top);
      const double du = left - 20, dv = top - 20;
      check_moved(
          here, walls_in(support::placed(picture, {240, 210}, left, top, 254), options),
          [&](Point2 p) {
            return Point2{p.x + du, p.y + dv};
          },
          0.05, 0.6);
    }
  }
}

TEST_CASE("a picture turned by quarters has turned lines") {
  const LineMapOptions options = followed_or_voted();
  for (const double angle : angles) {
    Image<std::uint8_t> picture = rooms(angle).picture();
    std::vector<Found> before = walls_in(picture, options);
    REQUIRE(before.size() >= 6);
    for (int quarter = 1; quarter <= 3; ++quarter) {
      CAPTURE(angle, quarter);
      const double height = picture.height();
      picture = support::turned_clockwise(picture);
      std::vector<Found> after = walls_in(picture, options);
      check_moved(
          before, after,
          [&](Point2 p) {
            return Point2{height - p.y, p.x};
          },
          0.08, 0.8);
      before = std::move(after);
    }
  }
}

TEST_CASE("a mirrored picture has mirrored lines") {
  const LineMapOptions options = followed_or_voted();
  for (const double angle : angles) {
    CAPTURE(angle);
    const Image<std::uint8_t> picture = rooms(angle).picture();
    check_moved(
        walls_in(picture, options), walls_in(support::mirrored(picture), options),
        [](Point2 p) {
          return Point2{size.width - p.x, p.y};
        },
        0.08, 0.8);
  }
}

TEST_CASE("a border of unknown space changes no line") {
  LineMapOptions options = followed_or_voted();
  for (const double angle : angles) {
    CAPTURE(angle);
    const Image<std::uint8_t> picture = rooms(angle).picture();
    for (const bool with_meaning : {false, true}) {
      if (with_meaning) options.meaning = RosMeaning{};
      check_moved(
          walls_in(picture, options), walls_in(support::placed(picture, {230, 190}, 30, 25, 205), options),
          [](Point2 p) {
            return Point2{p.x + 30, p.y + 25};
          },
          0.05, 0.6);
    }
  }
}

TEST_CASE("every method finds the drawn walls") {
  for (const double angle : angles) {
    const Image<std::uint8_t> picture = rooms(angle).picture();
    const auto at = [&](double x, double y) {
      return Point2{90 + x * std::cos(angle) - y * std::sin(angle),
                    75 + x * std::sin(angle) + y * std::cos(angle)};
    };
    for (const LineMapOptions& options : plan::all_methods()) {
      const int method = options.hough ? static_cast<int>(options.hough->method) : -1;
      const std::vector<Found> found = walls_in(picture, options);
      for (const Wall& wall : {Wall{at(-50, -40), at(50, -40)}, Wall{at(50, -40), at(50, 20)},
                               Wall{at(-50, -15), at(-10, -15)}, Wall{at(12, -15), at(50, -15)},
                               Wall{at(-45, 20.5), at(20, 20.5)}, Wall{at(-45, 29.5), at(20, 29.5)}}) {
        CAPTURE(angle, method, wall.a.x, wall.a.y);
        const std::vector<Found> here = plan::beside(found, wall);
        REQUIRE(here.size() == 1);
        CHECK(plan::end_error(here[0].wall, wall) < 1.5);
      }
    }
  }
}

TEST_CASE("any seed of the Hough transform gives the same walls") {
  const Image<std::uint8_t> picture = rooms(0.21).picture();
  LineMapOptions options{.hough = line_map_hough};
  const std::vector<Found> first = walls_in(picture, options);
  for (std::uint64_t seed = 2; seed <= 12; ++seed) {
    CAPTURE(seed);
    options.hough->seed = seed;
    check_moved(
        first, walls_in(picture, options), [](Point2 p) { return p; }, 0.08, 0.8);
  }
}
