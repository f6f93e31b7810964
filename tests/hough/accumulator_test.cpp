// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_accumulator.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "plane_scene.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Prepared {
  explicit Prepared(const HoughAccumulatorOptions& options) {
    Arena counted = Arena::measure();
    HoughAccumulator().take(counted, options);
    memory.resize(counted.used());
    Arena arena(memory);
    accumulator.take(arena, options);
    REQUIRE_FALSE(arena.failed());
    accumulator.fill(options.cells);
  }
  const HoughDirections& directions() const { return accumulator.directions(); }

  std::vector<std::byte> memory;
  HoughAccumulator accumulator;
};

constexpr HoughCells kinds[] = {HoughCells::array, HoughCells::ball};
constexpr int row_counts[] = {4, 5, 6, 9, 30, 45, 64};

}  // namespace

TEST_CASE("cells are counted beforehand, and bad numbers of them refused") {
  static_assert(HoughDirections::cell_count(HoughCells::array, 45) == 45 * 90);
  static_assert(HoughDirections::cell_count(HoughCells::ball, 45) == 2474);
  static_assert(HoughDirections::cell_count(HoughCells::ball, 30) == 1074);
  CHECK(HoughDirections::cell_count(HoughCells::ball, 3) == 0);
  CHECK(HoughDirections::cell_count(HoughCells::ball, 1025) == 0);
  CHECK(HoughDirections::cell_count(static_cast<HoughCells>(9), 45) == 0);
  CHECK(HoughAccumulator::cell_count({HoughCells::ball, 45, 0}) == 0);
  CHECK(HoughAccumulator::cell_count({HoughCells::ball, 45, 65537}) == 0);
  CHECK(HoughAccumulator::cell_count({HoughCells::array, 1024, 65536}) == 0);
  CHECK(HoughAccumulator::cell_count({}) == 2474U * 128U);
}

TEST_CASE("cells cover the sphere; the ball's are equal, the array's are not") {
  for (const HoughCells kind : kinds) {
    for (const int rows : row_counts) {
      INFO("kind " << static_cast<int>(kind) << " rows " << rows);
      const Prepared p({kind, rows, 1});
      double sum = 0, least = 100, most = 0;
      for (std::int32_t cell = 0; cell < p.directions().size(); ++cell) {
        const double area = p.directions().area(cell);
        sum += area;
        least = std::min(least, area);
        most = std::max(most, area);
      }
      CHECK(sum == Approx(4 * pi).epsilon(1e-12));
      if (kind == HoughCells::ball) CHECK(most == Approx(least).epsilon(1e-9));
      if (kind == HoughCells::array && rows == 45) CHECK(most / least == Approx(28.65).epsilon(0.01));
    }
  }
}

TEST_CASE("a cell's centre lies in it, and the antipode's opposite") {
  for (const HoughCells kind : kinds) {
    for (const int rows : row_counts) {
      INFO("kind " << static_cast<int>(kind) << " rows " << rows);
      const Prepared p({kind, rows, 1});
      const HoughDirections& directions = p.directions();
      for (std::int32_t cell = 0; cell < directions.size(); ++cell) {
        const Vector3& centre = directions.centre(cell);
        CHECK(length(centre) == Approx(1).epsilon(1e-14));
        CHECK(directions.cell(centre) == cell);
        const std::int32_t antipode = directions.antipode(cell);
        CHECK(directions.antipode(antipode) == cell);
        CHECK(length(directions.centre(antipode) + centre) < 1e-14);
      }
    }
  }
}

TEST_CASE("ball: cells are nearly as wide as high, from pole to pole") {
  const Prepared p({HoughCells::ball, 45, 1});
  CHECK(p.directions().cell_size() / degree > 3.75);
  for (const HoughRow& row : p.directions().rows()) {
    if (row.count == 1) continue;
    const double top = arc_tangent(__builtin_sqrt(1 - row.top * row.top), row.top);
    const double bottom = arc_tangent(__builtin_sqrt(1 - row.bottom * row.bottom), row.bottom);
    const double width = 2 * pi / row.count * sine((top + bottom) / 2);
    CHECK(width / (bottom - top) > 0.8);
    CHECK(width / (bottom - top) < 1.25);
  }
}

TEST_CASE("directions at the poles and at the seam have cells") {
  for (const HoughCells kind : kinds) {
    const Prepared p({kind, 45, 1});
    const HoughDirections& directions = p.directions();
    CHECK(directions.cell({0, 0, 1}) < directions.rows()[0].count);
    CHECK(directions.cell({0, 0, -1}) >= directions.size() - directions.rows()[0].count);
    CHECK(directions.cell({-1, 0, 0}) >= 0);
    CHECK(directions.cell({-1, -0.0, 0}) >= 0);
    CHECK(directions.cell({-1, 1e-300, 0}) < directions.size());
    CHECK(directions.cell({0, 0, 1 + 1e-15}) < directions.rows()[0].count);
  }
}

TEST_CASE("neighbours are mutual, and everyone is his own") {
  for (const HoughCells kind : kinds) {
    for (const int rows : {4, 7, 20}) {
      const Prepared p({kind, rows, 1});
      std::vector<std::set<std::int32_t>> neighbours;
      for (std::int32_t cell = 0; cell < p.directions().size(); ++cell) {
        std::set<std::int32_t> own;
        p.directions().for_neighbours(cell, [&](std::int32_t other) { CHECK(own.insert(other).second); });
        CHECK(own.count(cell) == 1);
        neighbours.push_back(own);
      }
      for (std::size_t cell = 0; cell < neighbours.size(); ++cell) {
        for (const std::int32_t other : neighbours[cell]) {
          CHECK(neighbours[static_cast<std::size_t>(other)].count(static_cast<std::int32_t>(cell)) == 1);
        }
      }
    }
  }
}

TEST_CASE("distance cells, and votes shared between two of them") {
  Prepared p({HoughCells::ball, 10, 20});
  HoughAccumulator& a = p.accumulator;
  a.clear(0.25);
  CHECK(a.distance_cell(0) == 0);
  CHECK(a.distance_cell(0.2499) == 0);
  CHECK(a.distance_cell(0.25) == 1);
  CHECK(a.distance_cell(4.99) == 19);
  CHECK(a.distance_cell(1e9) == 19);
  CHECK(a.distance_of(2) == 0.625);

  const std::int32_t n = 17;
  a.vote(n, 0.625, 100);  // the middle of cell 2
  CHECK(a.votes(n, 2) == 100);
  a.vote(n, 1.0, 100);  // between 3 and 4
  CHECK(a.votes(n, 3) == 50);
  CHECK(a.votes(n, 4) == 50);
  a.vote(n, -0.625, 7);
  CHECK(a.votes(a.directions().antipode(n), 2) == 7);
  a.vote(n, 0, 60);
  CHECK(a.votes(n, 0) == 30);
  CHECK(a.votes(a.directions().antipode(n), 0) == 30);
  CHECK(a.votes_beside(n, -1) == 30);
  CHECK(a.votes_beside(n, -3) == 7);
  CHECK(a.votes_beside(n, 20) == 0);
  a.vote(n, 1e6, 9);
  CHECK(a.votes(n, 19) == 9);
  a.clear(1);
  CHECK(std::count(a.votes().begin(), a.votes().end(), 0U) == static_cast<std::ptrdiff_t>(a.votes().size()));
}
