// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The example and the table that docs/hough-planes.md works out by hand. Whoever changes a number here
// changes it there.
#include <vector>

#include "plane_scene.hpp"
#include "straightedge/hough_accumulator.hpp"
#include "support/catch.hpp"

using namespace straightedge;

TEST_CASE("hough-planes.md: three points, one plane, its cell, and where each of them votes") {
  constexpr Vector3 a{0, 0, 2.5}, b{2, 0, 1}, c{2, 5, 1};
  CHECK(cross(b - a, c - a) == Vector3{7.5, 0, 10});
  const Vector3 n = normalized(cross(b - a, c - a));
  CHECK(dot(n, a) == Approx(2));

  constexpr HoughAccumulatorOptions options{HoughCells::ball, 45, 96};
  Arena counted = Arena::measure();
  HoughAccumulator accumulator;
  accumulator.take(counted, options);
  std::vector<std::byte> memory(counted.used());
  Arena arena(memory);
  accumulator.take(arena, options);
  accumulator.fill(options.cells);
  accumulator.clear(1.0 / 16);
  const HoughDirections& directions = accumulator.directions();

  const std::int32_t cell = directions.cell(n);
  CHECK(cell == 250);
  CHECK(directions.row_of(cell) == 9);
  CHECK(directions.rows()[9].first == 223);
  CHECK(directions.rows()[9].count == 54);
  CHECK(accumulator.distance_cell(2) == 32);
  const Vector3& centre = directions.centre(cell);
  CHECK(centre.x == Approx(0.601).margin(5e-4));
  CHECK(centre.y == Approx(0.035).margin(5e-4));
  CHECK(centre.z == Approx(0.798).margin(5e-4));
  CHECK(dot(centre, a) == Approx(1.996).margin(5e-4));
  CHECK(dot(centre, b) == Approx(2.001).margin(5e-4));
  CHECK(dot(centre, c) == Approx(2.175).margin(1e-3));
  CHECK(accumulator.distance_cell(dot(centre, a)) == 31);
  CHECK(accumulator.distance_cell(dot(centre, b)) == 32);
  CHECK(accumulator.distance_cell(dot(centre, c)) == 34);

  const std::int32_t counts[] = {1, 6, 12, 20};
  for (std::size_t row = 0; row < 4; ++row) CHECK(directions.rows()[row].count == counts[row]);
  CHECK(directions.area(cell) / (degree * degree) == Approx(16.7).margin(0.05));
  CHECK(static_cast<double>(memory.size()) / 1e6 == Approx(1.0).margin(0.05));
}
