// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/extent.hpp"

#include <algorithm>
#include <optional>

#include "map/support.hpp"
#include "stage_lines.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

constexpr Size size{160, 100};

std::vector<WallLine> extents(const support::Canvas& canvas, const std::vector<WallLine>& lines,
                              const ExtentOptions& options = {}, std::optional<RosMeaning> meaning = {}) {
  const Picture picture = understand_picture(canvas.picture(), PictureKind::map, meaning);
  const support::EdgeScene scene(picture.stretched);
  std::vector<WallLine> out = measure_extents(lines, picture, scene.blurred(), options);
  std::sort(out.begin(), out.end(),
            [](const WallLine& a, const WallLine& b) { return a.x_at(a.begin) < b.x_at(b.begin); });
  return out;
}

std::vector<WallLine> supported(const support::Canvas& canvas, const std::vector<WallLine>& lines) {
  Image<std::uint8_t> marks;
  return keep_supported(lines, understand_picture(canvas.picture(), PictureKind::map, {}), {}, marks);
}

/// The axis along v = 50 between two columns of the image plane.
WallLine axis(double from, double to, double width = 2.4) {
  return stage::axis({from - 0.5, 49.5}, {to - 0.5, 49.5}, width);
}

}  // namespace

TEST_CASE("ends are where the wall's gray crosses the half, whatever the edge pixels said") {
  for (const double end : {120.0, 120.3, 120.5, 120.8}) {
    for (const double wrong : {-3.0, 0.0, 4.0}) {
      CAPTURE(end, wrong);
      support::Canvas canvas(size);
      canvas.paint_bar({40, 50}, {end, 50}, 2.4);
      const auto out = extents(canvas, {axis(40 + wrong, end - wrong)});
      REQUIRE(out.size() == 1);
      CHECK(stage::begin_of(out[0]).x + 0.5 == Approx(40).margin(0.35));
      CHECK(stage::end_of(out[0]).x + 0.5 == Approx(end).margin(0.35));
    }
  }
}

TEST_CASE("a face ends where its wall ends") {
  support::Canvas canvas(size);
  canvas.paint_box(40.4, 50, 119.7, 64);
  const auto out = extents(canvas, {stage::face({42, 49.5}, {116, 49.5})});
  REQUIRE(out.size() == 1);
  CHECK(stage::begin_of(out[0]).x + 0.5 == Approx(40.4).margin(0.5));
  CHECK(stage::end_of(out[0]).x + 0.5 == Approx(119.7).margin(0.5));
  CHECK(out[0].free_plus);
  CHECK_FALSE(out[0].free_minus);
}

TEST_CASE("holes up to max_gap are bridged, longer ones part the wall") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 50}, {80, 50}, 2.4);
  canvas.paint_bar({88, 50}, {140, 50}, 2.4);
  CHECK(extents(canvas, {axis(30, 140)}, {.max_gap = 12}).size() == 1);
  // Pieces that hold less than half of the whole line's pixels come from lines of their own.
  const auto parted = extents(canvas, {axis(30, 80), axis(88, 140)}, {.max_gap = 5});
  REQUIRE(parted.size() == 2);
  CHECK(stage::end_of(parted[0]).x + 0.5 == Approx(80).margin(0.4));
  CHECK(stage::begin_of(parted[1]).x + 0.5 == Approx(88).margin(0.4));
}

TEST_CASE("a wall that stands across ends a face and lets an axis through when it is thin") {
  support::Canvas canvas(size);
  canvas.paint_box(30, 50, 140, 64);
  canvas.paint_box(80, 20, 100, 50);
  const auto faces =
      extents(canvas, {stage::face({31, 49.5}, {78, 49.5}), stage::face({101, 49.5}, {138, 49.5})});
  REQUIRE(faces.size() == 2);
  CHECK(stage::end_of(faces[0]).x + 0.5 == Approx(80).margin(1));
  CHECK(stage::begin_of(faces[1]).x + 0.5 == Approx(100).margin(1));
  support::Canvas crossing(size);
  crossing.paint_bar({30, 50}, {140, 50}, 2.4);
  crossing.paint_bar({85, 20}, {85, 80}, 2.4);
  const auto through = extents(crossing, {axis(30, 140)});
  REQUIRE(through.size() == 1);
  CHECK(through[0].length() == Approx(110).margin(0.7));
}

TEST_CASE("what is too pale for the map's thresholds is left out") {
  support::Canvas canvas(size, 254);
  canvas.paint_bar({30, 30}, {140, 30}, 3, 0);
  canvas.paint_bar({30, 50}, {140, 50}, 3, 150);
  CHECK(extents(canvas, {axis(30, 140, 3)}, {}, RosMeaning{}).empty());
  CHECK(extents(canvas, {axis(30, 140, 3)}, {}, RosMeaning{.occupied_thresh = 0.3}).size() == 1);
}

TEST_CASE("free sides are told by the ground's lightness") {
  support::Canvas canvas(size, 254);
  canvas.paint_box(0, 0, 160, 50, 205);
  canvas.paint_bar({30, 50}, {140, 50}, 2.4);
  const auto out = extents(canvas, {axis(30, 140)}, {}, RosMeaning{});
  REQUIRE(out.size() == 1);
  // The normal of a line that runs to the right points up, where it is unknown.
  CHECK(out[0].ny == Approx(-1));
  CHECK_FALSE(out[0].free_plus);
  CHECK(out[0].free_minus);
}

TEST_CASE("a solid wall is supported, a dotted line of crumbs is not") {
  support::Canvas solid(size), dotted(size);
  solid.paint_bar({30, 50}, {140, 50}, 2.4);
  dotted.paint_bar({10, 90}, {150, 90}, 2.4);
  for (double u = 30; u < 140; u += 9) dotted.paint_box(u, 48.8, u + 4, 51.2);
  const auto kept = supported(solid, {axis(30, 140)});
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].length() == Approx(110).margin(1e-9));
  CHECK(supported(dotted, {axis(30, 140)}).empty());
}

TEST_CASE("the stretch of a segment that no wall supports is cut off") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 50}, {100, 50}, 2.4);
  const auto kept = supported(canvas, {axis(30, 140)});
  REQUIRE(kept.size() == 1);
  CHECK(stage::begin_of(kept[0]).x + 0.5 == Approx(30).margin(1e-6));
  CHECK(stage::end_of(kept[0]).x + 0.5 == Approx(101).margin(2.5));
}

TEST_CASE("no lines have no extent and no support") {
  const support::Canvas canvas(size);
  CHECK(extents(canvas, {}).empty());
  CHECK(supported(canvas, {}).empty());
  CHECK(supported(canvas, {axis(30, 140)}).empty());
}
