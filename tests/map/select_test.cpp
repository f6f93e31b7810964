// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/select.hpp"

#include <cmath>
#include <vector>

#include "map/candidates.hpp"
#include "stage_lines.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

constexpr Size size{160, 120};

std::uint32_t set_pixels(GrayView mask) {
  std::uint32_t count = 0;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) count += mask.at(x, y) != 0 ? 1 : 0;
  }
  return count;
}

support::EdgeScene box() {
  support::Canvas canvas(size);
  canvas.paint_box(40, 40, 120, 80);
  return support::EdgeScene(canvas.picture());
}

EdgePoints points_of(const support::EdgeScene& scene) {
  EdgePoints points;
  points.find(scene.mask, scene.field(), GradientNorm::l1, best_kernels());
  return points;
}

}  // namespace

TEST_CASE("rough duplicates of one edge give one edge, its pixels taken") {
  const support::EdgeScene scene = box();
  const std::uint32_t before = set_pixels(scene.mask);
  const std::vector<HoughSegment> rough{{60, 39, 100, 39, 30, 40},
                                        {45, 40, 90, 39, 20, 40},
                                        {70, 39, 118, 40, 25, 40},
                                        {50, 40, 110, 40, 60, 40}};
  EdgePoints points = points_of(scene);
  const auto edges = select_edges(rough, {}, 6, points);
  REQUIRE(edges.size() == 1);
  CHECK(edges[0].fit.centroid_y == Approx(39.5).margin(0.05));
  CHECK(edges[0].ny == Approx(-1).margin(1e-3));  // light above
  CHECK(edges[0].length() == Approx(80).margin(6));
  const std::uint32_t taken = before - set_pixels(points.mask());
  CHECK(taken >= edges[0].pixels);
  CHECK(taken <= edges[0].pixels + 8);
}

TEST_CASE("edges shorter than asked for and rough segments on nothing are left out, their pixels free") {
  const support::EdgeScene scene = box();
  EdgePoints points = points_of(scene);
  CHECK(select_edges(std::vector<HoughSegment>{{60, 39, 100, 39, 1, 1}}, {}, 100, points).empty());
  CHECK(select_edges(std::vector<HoughSegment>{{60, 10, 100, 10, 1, 1}}, {}, 6, points).empty());
  CHECK(select_edges({}, {}, 6, points).empty());
  CHECK(set_pixels(points.mask()) == set_pixels(scene.mask));
}

TEST_CASE("the four edges of a box are found by every method, each once") {
  for (const HoughMethod method :
       {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
    CAPTURE(static_cast<int>(method));
    const support::EdgeScene scene = box();
    const Image<std::uint8_t> before = scene.mask;
    LineMapOptions options{.hough = line_map_hough};
    options.hough->method = method;
    EdgeRoom room;
    std::vector<WallLine> lines;
    LineMapReport report;
    REQUIRE(find_edges(scene.mask, scene.field(), options, best_kernels(), room, lines, report) ==
            Status::ok);
    CHECK(scene.mask == before);
    CHECK(lines.size() == 4);
    CHECK(report.edges == lines.size());
    CHECK(report.candidates >= 4);
    CHECK(report.rounds >= 1);
    std::uint32_t pixels = 0;
    for (const WallLine& line : lines) {
      CHECK(std::fmin(std::fabs(line.nx), std::fabs(line.ny)) < 0.01);
      CHECK_FALSE(line.axis);
      pixels += line.pixels;
    }
    CHECK(pixels <= set_pixels(before));  // no pixel carries two edges
  }
}

TEST_CASE("bad options of the Hough transform come back as its status") {
  const support::EdgeScene scene = box();
  LineMapOptions options{.hough = line_map_hough};
  options.hough->threshold = 0;
  EdgeRoom room;
  std::vector<WallLine> lines;
  LineMapReport report;
  CHECK(find_edges(scene.mask, scene.field(), options, best_kernels(), room, lines, report) ==
        Status::invalid_option);
}

TEST_CASE("a picture too wide for the Hough transform is refused before it takes memory") {
  const Size wide{32768, 1};
  const Image<std::uint8_t> edges(wide, 255);
  const Image<std::int16_t> gradient(wide);
  EdgeRoom room;
  std::vector<WallLine> lines;
  LineMapReport report;
  CHECK(find_edges(edges, GradientField{gradient, gradient, {}}, {}, best_kernels(), room, lines, report) ==
        Status::too_large);
  CHECK(room.points.size() == Size{});
}
