// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "map/plane_extent.hpp"
#include "map/plane_raster.hpp"
#include "plane_scene.hpp"

using namespace straightedge;
using scene::Frame;
using scene::Rectangle;

namespace {

std::size_t holes(const std::vector<ExtentLoop>& loops) {
  return static_cast<std::size_t>(
      std::count_if(loops.begin(), loops.end(), [](const ExtentLoop& l) { return l.area < 0; }));
}

double total_area(const std::vector<ExtentLoop>& loops) {
  double sum = 0;
  for (const ExtentLoop& loop : loops) sum += loop.area;
  return sum;
}

/// Covered with `tenths` of its cells, but not within `rim` of its sides.
Raster random_raster(Pcg32& random, std::int32_t width, std::int32_t height, std::int32_t rim,
                     std::uint32_t tenths) {
  Raster raster(width, height);
  raster.cell = 1;
  for (std::int32_t y = rim; y < height - rim; ++y) {
    for (std::int32_t x = rim; x < width - rim; ++x) raster.set(y, x, x + 1, random.below(10) < tenths);
  }
  return raster;
}

/// Whether a cell within `reach` of (x, y), by sides and corners, has the value.
bool near(const Raster& raster, std::int32_t x, std::int32_t y, std::int32_t reach, bool value) {
  for (std::int32_t b = std::max(y - reach, 0); b <= std::min(y + reach, raster.height - 1); ++b) {
    for (std::int32_t a = std::max(x - reach, 0); a <= std::min(x + reach, raster.width - 1); ++a) {
      if (raster.covered(a, b) == value) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("closing grows and shrinks again, cell by cell") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    const auto reach = static_cast<std::int32_t>(seed < 20 ? 1 + seed % 6 : 20 * (seed - 19));
    const std::int32_t rim = 2 * reach + 1;
    const std::int32_t width = 2 * rim + 1 + static_cast<std::int32_t>(random.below(180));
    Raster raster = random_raster(random, width, 2 * rim + 9, rim, seed % 2 == 0 ? 1 : 3);
    Raster grown(raster.width, raster.height);
    for (std::int32_t y = 0; y < raster.height; ++y) {
      for (std::int32_t x = 0; x < width; ++x) grown.set(y, x, x + 1, near(raster, x, y, reach, true));
    }
    close_gaps(raster, 2 * reach);
    std::size_t wrong = 0;
    for (std::int32_t y = 0; y < raster.height; ++y) {
      for (std::int32_t x = 0; x < width; ++x)
        wrong += raster.covered(x, y) == near(grown, x, y, reach, false) ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("of a piece that leans the corners are not painted") {
  const ExtentPiece whole{-0.5, 0.5, -0.5, 0.5};
  ExtentPiece piece = whole;
  piece.oblique = true;
  const double slope = GENERATE(-0.5, 0.5);
  piece.strips[0] = {slope, 0.25};     // |a − slope b| <= 0.25
  piece.strips[1] = {1 / slope, 0.5};  // |b − slope a| <= 0.25
  Raster raster = raster_for(std::vector<ExtentPiece>{whole}, 1.0 / 64, 0.1);
  paint(raster, piece);
  std::size_t wrong = 0;
  for (std::int32_t y = 0; y < raster.height; ++y) {
    for (std::int32_t x = 0; x < raster.width; ++x) {
      const double a = raster.origin.a + (x + 0.5) * raster.cell,
                   b = raster.origin.b + (y + 0.5) * raster.cell;
      const double out = std::max({std::abs(a) - 0.5, std::abs(b) - 0.5, std::abs(a - slope * b) - 0.25,
                                   std::abs(b - slope * a) - 0.25});
      if (std::abs(out) > raster.cell) wrong += raster.covered(x, y) == (out > 0) ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a rectangle is four corners") {
  const std::vector<ExtentPiece> piece{{-1, 2, 0.5, 1.5}};
  const auto loops = extent_loops(piece, {});
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].points.size() == 4);
  CHECK(loops[0].area == Approx(3).margin(0.001));
  CHECK(signed_area(loops[0].points) == Approx(loops[0].area));
}

TEST_CASE("small holes and narrow gaps close, wide ones stay") {
  const std::vector<ExtentPiece> ring{{0, 2, 0, 0.5}, {0, 2, 1.5, 2}, {0, 0.5, 0, 2}, {1.5, 2, 0, 2}};
  CHECK(holes(extent_loops(ring, {})) == 1);
  CHECK(total_area(extent_loops(ring, {})) == Approx(3).margin(0.01));
  ExtentOptions large;
  large.max_hole = 1.1;
  CHECK(holes(extent_loops(ring, large)) == 0);
  const std::vector<ExtentPiece> near{{0, 1, 0, 1}, {1.1, 2, 0, 1}}, far{{0, 1, 0, 1}, {1.3, 2, 0, 1}};
  CHECK(extent_loops(near, {}).size() == 1);
  CHECK(extent_loops(far, {}).size() == 2);
}

TEST_CASE("small islands go, unless there is nothing else") {
  const std::vector<ExtentPiece> both{{0, 1, 0, 1}, {3, 3.05, 0, 0.05}};
  CHECK(extent_loops(both, {}).size() == 1);
  CHECK(extent_loops(std::vector<ExtentPiece>{both[1]}, {}).size() == 1);
  CHECK(extent_loops({}, {}).empty());
}

TEST_CASE("parts of a plane that lie kilometres apart need no memory in between") {
  const std::vector<ExtentPiece> parts{{0, 1, 0, 1}, {50000, 50001, 90000, 90001}};
  const auto loops = extent_loops(parts, {});
  REQUIRE(loops.size() == 2);
  CHECK(total_area(loops) == Approx(2).margin(0.01));
}

TEST_CASE("pieces that are no rectangles are passed over") {
  const double nan = __builtin_nan("");
  const std::vector<ExtentPiece> odd{{nan, 1, 0, 1}, {0, 1, 2, 1}, {0, 1e9, 0, 1}, {0, 1, 0, 1}};
  CHECK(total_area(extent_loops(odd, {})) == Approx(1).margin(0.01));
}

TEST_CASE("borders of random pictures enclose what is covered, outer ones to the left, holes to the right") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    const Raster raster = random_raster(random, static_cast<std::int32_t>(3 + 10 * seed), 17, 1, 6);
    std::int64_t covered = 0;
    for (std::int32_t y = 0; y < raster.height; ++y) {
      for (std::int32_t x = 0; x < raster.width; ++x) covered += raster.covered(x, y) ? 1 : 0;
    }
    double area = 0;
    std::vector<ExtentLoop> loops;
    for (const CellLoop& cells : cell_borders(raster)) {
      ExtentLoop loop;
      for (std::size_t i = 0; i < cells.x.size(); ++i)
        loop.points.push_back({static_cast<double>(cells.x[i]), static_cast<double>(cells.y[i])});
      loop.area = signed_area(loop.points);
      area += loop.area;
      loops.push_back(loop);
    }
    CHECK(area == Approx(static_cast<double>(covered)));
    Raster painted(raster.width, raster.height);
    painted.cell = 1;
    paint(painted, loops);
    CHECK(painted.words == raster.words);
  }
}

TEST_CASE("a wall with a door and a window") {
  // The door reaches the floor and is part of the outer border; the window is a hole.
  const std::vector<Rectangle> wall{
      {{-2, 2, 0}, {4, 0, 0}, {0, 0, 2.5}, {{0.5, -0.1, 1.4, 2.0}, {2.4, 0.9, 3.4, 1.8}}, 1}};
  PlaneMapBuilder builder(scene::options());
  for (int i = 0; i < 12; ++i) {
    const double x = -1.6 + 0.3 * i;
    scene::add(builder, scene::seen(wall, scene::look({x, -1.2, 1.25}, {x, 2, 1.25}),
                                    30 + static_cast<std::uint64_t>(i)));
  }
  const PlaneMapReading reading = scene::read(builder);
  REQUIRE(reading.map.planes.size() == 1);
  const MapPlane& plane = reading.map.planes[0];
  REQUIRE(plane.polygons.size() == 2);
  CHECK_FALSE(plane.polygons[0].hole);
  CHECK(plane.polygons[1].hole);
  CHECK(scene::area(plane) == Approx(10 - 0.9 * 2.0 - 0.9).epsilon(0.03));
  CHECK(plane.polygons[0].points.size() <= 14);
  CHECK(plane.polygons[1].points.size() <= 6);
  for (const MapPolygon& polygon : plane.polygons) {
    for (const Vector3& v : polygon.points) CHECK(std::abs(plane.plane.signed_distance(v)) < 1e-9);
  }
}

TEST_CASE("a floor seen far and obliquely is one piece without holes") {
  const std::vector<Rectangle> floor{{{-3, 0, 0}, {6, 0, 0}, {0, 9, 0}, {}, 1}};
  PlaneMapBuilder builder(scene::options());
  scene::add(builder, scene::seen(floor, scene::look({0, 0, 1}, {0, 5, 0.2}), 5, 1, 8));
  const PlaneMapReading reading = scene::read(builder);
  REQUIRE(reading.map.planes.size() == 1);
  CHECK(reading.map.planes[0].polygons.size() == 1);
}
