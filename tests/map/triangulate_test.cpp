// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "staircase_maker.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// A frame on a plane: origin + s u + t v.
struct Frame {
  Vector3 origin, u{1, 0, 0}, v{0, 1, 0};
  Vector3 normal() const { return cross(u, v); }
  Vector3 at(double s, double t) const { return origin + s * u + t * v; }
};

Frame random_frame(std::mt19937& generator) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vector3 n = normalized({unit(generator), unit(generator), unit(generator)});
  const Vector3 u = normalized(cross(n, {unit(generator), unit(generator), 1.5}));
  return {{unit(generator) * 9, unit(generator) * 9, unit(generator) * 9}, u, cross(n, u)};
}

std::vector<MapPolygon> polygons_of(const Staircase& area, const Frame& frame, double cell, bool turn_left,
                                    bool all) {
  std::vector<MapPolygon> polygons;
  for (const auto& border : area.borders(turn_left, all)) {
    MapPolygon polygon;
    polygon.hole = signed_area(border) < 0;
    for (const auto& [x, y] : border) polygon.points.push_back(frame.at(cell * x, cell * y));
    polygons.push_back(polygon);
  }
  return polygons;
}

std::vector<Vector3> points_of(const std::vector<MapPolygon>& polygons) {
  std::vector<Vector3> points;
  for (const MapPolygon& polygon : polygons)
    points.insert(points.end(), polygon.points.begin(), polygon.points.end());
  return points;
}

struct Sum {
  double area = 0;
  double least = std::numeric_limits<double>::infinity();  ///< area of the smallest triangle
};

Sum sum_of(const std::vector<Triangle>& triangles, const std::vector<Vector3>& points,
           const Vector3& normal) {
  Sum sum;
  for (const Triangle& t : triangles) {
    const double area = dot(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]), normal) / 2;
    sum.area += area;
    sum.least = std::min(sum.least, area);
  }
  return sum;
}

/// Points that are no whole numbers lie off their lines by the rounding of the steps.
constexpr double sliver = 1e-8;

/// With every triangle turning left and the areas adding up, triangles whose middles lie within leave no room
/// for overlaps.
void check_staircase(const Staircase& area, const Frame& frame, double cell, bool turn_left, bool all) {
  const auto polygons = polygons_of(area, frame, cell, turn_left, all);
  const auto points = points_of(polygons);
  const auto triangles = triangulate(polygons, frame.normal());
  const Sum sum = sum_of(triangles, points, frame.normal());
  const double expected = area.count() * cell * cell;
  REQUIRE(sum.area == Approx(expected).epsilon(1e-6));
  const bool exact = frame.origin == Vector3{} && cell == 1;
  const double size = cell * area.size();
  REQUIRE(sum.least > (exact ? 0 : -sliver * size * size));
  for (const Triangle& t : triangles) {
    const Vector3 a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]];
    if (!exact && dot(cross(a, b), frame.normal()) < sliver * size * size) continue;
    const Vector3 middle = (1.0 / 3) * (points[t[0]] + points[t[1]] + points[t[2]]) - frame.origin;
    const double x = dot(middle, frame.u) / cell, y = dot(middle, frame.v) / cell;
    REQUIRE(area.has(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))));
  }
}

MapPolygon square(double x, double y, double side, bool hole = false) {
  MapPolygon polygon{hole, {{x, y, 0}, {x + side, y, 0}, {x + side, y + side, 0}, {x, y + side, 0}}};
  if (hole) std::reverse(polygon.points.begin(), polygon.points.end());
  return polygon;
}

double area_of(const std::vector<MapPolygon>& polygons) {
  const Vector3 up{0, 0, 1};
  const Sum sum = sum_of(triangulate(polygons, up), points_of(polygons), up);
  CHECK(sum.least > 0);
  return sum.area;
}

}  // namespace

TEST_CASE("triangles: a triangle, a square, a square with a hole") {
  const std::vector<MapPolygon> one{{false, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}};
  const auto triangles = triangulate(one, {0, 0, 1});
  REQUIRE(triangles.size() == 1);
  CHECK(std::set<std::uint32_t>(triangles[0].begin(), triangles[0].end()) ==
        std::set<std::uint32_t>{0, 1, 2});
  CHECK(triangulate(std::vector{square(0, 0, 1)}, {0, 0, 1}).size() == 2);
  const std::vector framed{square(0, 0, 4), square(1, 1, 2, true)};
  CHECK(triangulate(framed, {0, 0, 1}).size() == 8);
  CHECK(area_of(framed) == Approx(12));
}

TEST_CASE("triangles: holes that touch, islands in holes, several outer borders, any order") {
  std::vector<MapPolygon> polygons{square(1, 1, 1, true), square(2, 2, 1, true),  square(0, 0, 10),
                                   square(5, 5, 4, true), square(6, 6, 2),        square(6.5, 6.5, 1, true),
                                   square(20, 0, 3),      square(20, 1, 1, true), square(1, 3, 1, true)};
  const double expected = 100 - 3 - 16 + 4 - 1 + 9 - 1;
  CHECK(area_of(polygons) == Approx(expected));
  std::mt19937 generator(1);
  for (int i = 0; i < 50; ++i) {
    std::shuffle(polygons.begin(), polygons.end(), generator);
    CHECK(area_of(polygons) == Approx(expected));
  }
}

TEST_CASE("triangles: the sense of rotation is that of the kind, whatever the points say") {
  std::vector polygons{square(0, 0, 4), square(1, 1, 2, true)};
  for (MapPolygon& polygon : polygons) std::reverse(polygon.points.begin(), polygon.points.end());
  CHECK(area_of(polygons) == Approx(12));
}

TEST_CASE("triangles: nothing to cut") {
  const Vector3 up{0, 0, 1};
  CHECK(triangulate({}, up).empty());
  CHECK(triangulate(std::vector{square(0, 0, 0)}, up).empty());
  CHECK(triangulate(std::vector{square(0, 0, 1, true)}, up).empty());
  CHECK(triangulate(std::vector{MapPolygon{}}, up).empty());
  CHECK(triangulate(std::vector<MapPolygon>{{false, {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}}, up).empty());
  const double bad = std::numeric_limits<double>::quiet_NaN();
  CHECK(triangulate(std::vector<MapPolygon>{{false, {{0, 0, 0}, {bad, 0, 0}, {3, 9, 0}}}}, up).empty());
  CHECK(area_of({square(-1e150, 0, 1e150)}) == Approx(1e300));
}

TEST_CASE("triangles: random staircases with holes, apart and hanging together in corners") {
  const std::uint32_t seed = 50;
  std::mt19937 generator(seed);
  for (int round = 0; round < 400; ++round) {
    INFO("seed " << seed << ", round " << round);
    const int side = 2 + round % 30;
    const double share = std::uniform_real_distribution<double>(0.2, 0.95)(generator);
    const Staircase area = Staircase::random(side, side + 3, share, generator);
    const Frame frame = round % 3 == 0 ? Frame{} : random_frame(generator);
    for (const bool turn_left : {true, false}) {
      for (const bool all : {true, false})
        check_staircase(area, frame, round % 2 == 0 ? 1.0 : 0.05, turn_left, all);
    }
  }
}

TEST_CASE("triangles: a floor of many thousand corners, a spiral and a comb") {
  std::mt19937 generator(51);
  check_staircase(Staircase::random(150, 150, 0.7, generator), Frame{}, 0.1, true, false);
  check_staircase(Staircase::random(150, 150, 0.9, generator), random_frame(generator), 0.1, false, true);
  Staircase comb(2000, 20);
  for (int x = 0; x < 2000; ++x) {
    for (int y = 0; y < (x % 2 == 0 ? 20 : 3); ++y) comb.set(x, y);
  }
  check_staircase(comb, random_frame(generator), 0.1, true, true);
  constexpr int size = 121;
  Staircase spiral(size, size);
  int x = 0, y = 0, dx = 1, dy = 0;
  for (int step = 0; step < size * size; ++step) {
    spiral.set(x, y);
    const auto blocked = [&](int a, int b) {
      return a < 0 || b < 0 || a >= size || b >= size || spiral.has(a, b);
    };
    if (blocked(x + dx, y + dy) || spiral.has(x + 2 * dx, y + 2 * dy)) {
      std::swap(dx, dy);
      dx = -dx;
      if (blocked(x + dx, y + dy) || spiral.has(x + 2 * dx, y + 2 * dy)) break;
    }
    x += dx;
    y += dy;
  }
  check_staircase(spiral, Frame{}, 1, true, false);
  check_staircase(spiral, random_frame(generator), 1, true, true);
}

TEST_CASE("triangles: random slanted polygons with holes") {
  const std::uint32_t seed = 52;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> radius(0.6, 1);
  for (int round = 0; round < 300; ++round) {
    INFO("seed " << seed << ", round " << round);
    const Frame frame = random_frame(generator);
    const auto star = [&](double s, double t, double size, int points, bool hole) {
      MapPolygon polygon;
      polygon.hole = hole;
      for (int i = 0; i < points; ++i) {
        const double angle = 2 * 3.14159265358979 * i / points, r = size * radius(generator);
        polygon.points.push_back(frame.at(s + r * std::cos(angle), t + r * std::sin(angle)));
      }
      if (hole) std::reverse(polygon.points.begin(), polygon.points.end());
      return polygon;
    };
    std::vector<MapPolygon> polygons{star(0, 0, 10, 3 + round % 60, false)};
    for (int i = -1; round % 60 > 9 && i < 2; ++i) {
      for (int k = -1; k < 2; ++k) polygons.push_back(star(2.5 * i, 2.5 * k, 1.2, 3 + round % 13, true));
    }
    double expected = 0;
    for (const MapPolygon& polygon : polygons) {
      for (std::size_t i = 2; i < polygon.points.size(); ++i) {
        const Vector3 a = polygon.points[i - 1] - polygon.points[0],
                      b = polygon.points[i] - polygon.points[0];
        expected += dot(cross(a, b), frame.normal()) / 2;
      }
    }
    const Sum sum = sum_of(triangulate(polygons, frame.normal()), points_of(polygons), frame.normal());
    REQUIRE(sum.least > -sliver * 100);
    REQUIRE(sum.area == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("triangles: borders that cross come to an end") {
  const std::uint32_t seed = 53;
  std::mt19937 generator(seed);
  const auto place = [](std::mt19937& from) { return static_cast<double>(from() % 6); };
  for (int round = 0; round < 2000; ++round) {
    std::vector<MapPolygon> polygons(1 + generator() % 4);
    for (MapPolygon& polygon : polygons) {
      polygon.hole = generator() % 2 == 0;
      polygon.points.resize(generator() % 12);
      for (Vector3& p : polygon.points) p = {place(generator), place(generator), 0};
    }
    const auto points = points_of(polygons);
    for (const Triangle& t : triangulate(polygons, {0, 0, 1})) {
      for (const std::uint32_t corner : t) REQUIRE(corner < points.size());
    }
  }
}
