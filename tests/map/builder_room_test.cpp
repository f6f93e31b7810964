// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "draw_plan.hpp"

using namespace straightedge;

namespace {

Image<std::uint8_t> plan_of(Size size, double thickness) {
  support::Canvas canvas(size, 254);
  canvas.paint_bar({30, 30}, {150, 30}, thickness);
  canvas.paint_bar({30, 90}, {150, 100}, thickness);
  return canvas.picture();
}

std::string text_of(const LineMap& map) {
  const auto text = line_map_to_xml(map);
  REQUIRE(text);
  return *text;
}

}  // namespace

TEST_CASE("a builder used again and again gives the maps of a new one") {
  for (const LineMapOptions& options :
       {LineMapOptions{}, LineMapOptions{.hough = line_map_hough}, LineMapOptions{.refine = false}}) {
    LineMapBuilder builder(options);
    for (const Size size : {Size{180, 120}, Size{200, 160}, Size{180, 120}}) {
      for (const double thickness : {2.0, 8.0}) {
        const auto picture = plan_of(size, thickness);
        const auto again = builder.build(picture);
        const auto fresh = build_line_map(picture, options);
        REQUIRE(again);
        REQUIRE(fresh);
        CHECK(!again->map.lines.empty());
        CHECK(text_of(again->map) == text_of(fresh->map));
      }
    }
  }
}

TEST_CASE("lines are the same where gradients are kept and where they are made anew") {
  // With 24 rows more a picture has more than half a million pixels; the origin lies in the middle.
  constexpr double lower = 12;
  for (const bool refine : {true, false}) {
    for (const double thickness : {2.0, 8.0}) {
      const auto kept = build_line_map(plan_of({700, 740}, thickness), {.refine = refine});
      const auto made = build_line_map(plan_of({700, 764}, thickness), {.refine = refine});
      REQUIRE(kept);
      REQUIRE(made);
      REQUIRE(!kept->map.lines.empty());
      REQUIRE(made->map.lines.size() == kept->map.lines.size());
      for (std::size_t i = 0; i < kept->map.lines.size(); ++i) {
        const auto &a = kept->map.lines[i].segments, &b = made->map.lines[i].segments;
        REQUIRE(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
          CHECK(b[k].x0 == Approx(a[k].x0));
          CHECK(b[k].x1 == Approx(a[k].x1));
          CHECK(b[k].y0 == Approx(a[k].y0 + lower));
          CHECK(b[k].y1 == Approx(a[k].y1 + lower));
        }
      }
    }
  }
}

TEST_CASE("without refinement the faces of thick bars are lines, each once") {
  const auto built = build_line_map(plan_of({180, 120}, 8), {.refine = false});
  REQUIRE(built);
  CHECK(built->report.rounds == 0);
  CHECK(built->report.walls == 0);
  CHECK(built->report.edges == built->report.lines + built->report.too_short + built->report.merged);
  double found = 0;
  for (const MapLine& line : built->map.lines) {
    REQUIRE(line.segments.size() == 1);
    const MapSegment& s = line.segments.front();
    const double length = std::hypot(s.x1 - s.x0, s.y1 - s.y0);
    if (length < 60) continue;
    found += length;
    // Both bars are 8 thick; their axes in the map's frame: y = 30, and from (-60, -30) to (60, -40).
    const double x = 0.5 * (s.x0 + s.x1), y = 0.5 * (s.y0 + s.y1);
    const double off = y > 0 ? std::fabs(y - 30) : std::fabs(y + 35 + x / 12) * std::cos(std::atan(1.0 / 12));
    CHECK(off == Approx(4).margin(0.1));
    CHECK(line.covariance->var_offset < 0.01);
  }
  CHECK(found == Approx(4 * 120).margin(4 * 8));
}

TEST_CASE("without refinement thin bars are axes, and in a photo they have two edges") {
  const auto plan = plan_of({180, 120}, 3);
  const auto built = build_line_map(plan, {.refine = false});
  REQUIRE(built);
  CHECK(built->report.walls == 2);
  REQUIRE(built->map.lines.size() == 2);
  for (const MapLine& line : built->map.lines) {
    CHECK(line.width == Approx(3).margin(0.3));
    const MapSegment& s = line.segments.front();
    const double x = 0.5 * (s.x0 + s.x1), y = 0.5 * (s.y0 + s.y1);
    CHECK((y > 0 ? y - 30 : y + 35 + x / 12) == Approx(0).margin(0.1));
  }
  const auto photo = build_line_map(plan, {.picture = PictureKind::photo, .refine = false});
  REQUIRE(photo);
  CHECK(photo->report.walls == 0);
  CHECK(photo->map.lines.size() >= 4);
}

TEST_CASE("bad options and pictures without pixels are refused without refinement, too") {
  CHECK(!build_line_map({}, {.refine = false}));
  const auto built = build_line_map(plan_of({180, 120}, 8), {.min_length = 2, .refine = false});
  REQUIRE(!built);
  CHECK(built.failure().problem == Problem::bad_option);
}

TEST_CASE("without refinement nobody votes, so options of votes are refused, not ignored") {
  const auto built = build_line_map(plan_of({180, 120}, 8), {.hough = line_map_hough, .refine = false});
  REQUIRE(!built);
  CHECK(built.failure().problem == Problem::bad_option);
  CHECK(built.failure().sentence.find("hough") != std::string::npos);
}
