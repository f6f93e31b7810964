// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/floor_svg.hpp"

#include <limits>
#include <string>

#include "catch.hpp"
#include "io/svg_size.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;

namespace {

/// A wall from (0, 0) to (10, 0) with the floor above it, and one from (0, 0) to (0, 5).
LineMap corner() {
  LineMap map;
  map.unit = MapUnit::metre;
  MapLine floor_above;
  floor_above.id = 0, floor_above.theta = pi / 2, floor_above.free = FreeSide::plus;
  floor_above.segments = {{7, 10, 0, 0, 0, {}}};
  MapLine left;
  left.id = 1, left.theta = 0;
  left.segments = {{8, 0, 0, 0, 5, {}}};
  map.lines = {floor_above, left};
  return map;
}

/// How many elements of a class there are; the text must be XML.
int count(const std::string& svg, const std::string& style) {
  REQUIRE(io::svg_size(svg).width > 0);
  int found = 0;
  const std::string wanted = "class=\"" + style + "\"";
  for (std::size_t at = svg.find(wanted); at != std::string::npos; at = svg.find(wanted, at + 1)) ++found;
  return found;
}

/// The dots of the readings, each a move and a stroke of no length.
std::size_t dots(const std::string& svg) {
  const std::size_t from = svg.find("class=\"few\" d=\"");
  const std::string d = svg.substr(from, svg.find('"', from + 16) - from);
  std::size_t found = 0;
  for (std::size_t at = d.find("h0"); at != std::string::npos; at = d.find("h0", at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("walls and what is laid on them, each with its entry in the legend") {
  FloorDrawing drawing;
  drawing.title = "a < b & \"c\"";
  drawing.description = "made by a test";
  CHECK(count(floor_to_svg(corner(), drawing), "wall") == 2);
  CHECK(count(floor_to_svg(corner(), drawing), "way") == 0);
  drawing.readings = {{1, 1}, {2, 1}};
  drawing.ways = {{FloorPath::robot, {{1, 1}, {3, 2}}}, {FloorPath::truth, {}}};
  drawing.segments = {{FloorLine::matched, {2, 0}, {4, 0}, "3"}, {FloorLine::refused, {5, 1}, {6, 1}, ""}};
  drawing.marks = {
      {FloorRobot::pose, {1, 1, 0.5}, std::array<double, 9>{0.01, 0, 0, 0, 0.04, 0, 0, 0, 0.01}}};
  drawing.bold_walls = {7};
  const std::string svg = floor_to_svg(corner(), drawing);
  for (const char* style : {"wall", "bold", "few", "way", "matched", "refused", "pose"}) {
    INFO(style);
    CHECK(count(svg, style) == 2);
  }
  CHECK(count(svg, "truth") == 0);
  CHECK(count(svg, "sigma") == 1);
  CHECK(count(svg, "on-matched") == 1);
  CHECK(count(svg, "on-refused") == 0);
  CHECK(svg.find("a &lt; b &amp; ") != std::string::npos);
  CHECK(svg == floor_to_svg(corner(), drawing));
}

TEST_CASE("y is up, and the scale is told") {
  FloorDrawing drawing;
  drawing.marks = {{FloorRobot::start, {0, 5, pi / 2}, {}}};
  const std::string svg = floor_to_svg(corner(), drawing);
  // 10.8 m on 1000 pixels, 0.4 m of margin: (0, 5) is at (37, 37), and the tip points to the top.
  CHECK(svg.find("M37.0 28.0L") != std::string::npos);
  CHECK(svg.find(">2 m</text>") != std::string::npos);
}

TEST_CASE("of readings on one spot one is drawn; those outside and those that are no points are not") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  FloorDrawing drawing;
  for (int i = 0; i < 500; ++i) drawing.readings.push_back({3 + i * 1e-6, 2});
  drawing.readings.push_back({4, 2});
  drawing.readings.push_back({none, 2});
  drawing.readings.push_back({4, std::numeric_limits<double>::infinity()});
  drawing.readings.push_back({4000, 2});
  CHECK(dots(floor_to_svg(corner(), drawing)) == 2);
}

TEST_CASE("numbers that cannot be drawn do no harm") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  FloorDrawing drawing;
  drawing.view = {{none, 0}};
  drawing.ways = {{FloorPath::robot, {{none, 1}, {1e300, 2}, {2, 2}}}};
  drawing.segments = {{FloorLine::seen, {none, 0}, {1, 1}, "x"}};
  drawing.marks = {{FloorRobot::end, {none, 0, 0}, {}},
                   {FloorRobot::end, {1, 1, 0}, std::array<double, 9>{none, 0, 0, 0, 1, 0, 0, 0, 1}}};
  const std::string svg = floor_to_svg(corner(), drawing);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  CHECK(count(svg, "sigma") == 0);
  CHECK(count(floor_to_svg({}, {}), "wall") == 0);
}

TEST_CASE("a view shows what surrounds its points; the legend breaks into rows") {
  FloorDrawing drawing;
  drawing.view = {{0, 0}, {0, 40}};
  drawing.readings = {{1, 1}};
  for (const FloorRobot kind :
       {FloorRobot::start, FloorRobot::end, FloorRobot::expected, FloorRobot::candidate})
    drawing.marks.push_back({kind, {0, 0, 0}, {}});
  const std::string svg = floor_to_svg(corner(), drawing);
  const Size size = io::svg_size(svg);
  CHECK(size.width < 200);
  CHECK(size.height > 1000 + 5 * 20);
}
