// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/segment_refit.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

constexpr Size size{120, 100};

/// Every pixel an edge pixel, the gradient the same everywhere.
struct EvenField {
  support::GuardedImage<std::int16_t> x, y;
  support::GuardedImage<std::int32_t> magnitude;
  support::GuardedImage<std::uint8_t> mask;

  EvenField(Size extent, double angle)
      : x(extent, 3, static_cast<std::int16_t>(std::lround(1000 * std::cos(angle)))),
        y(extent, 5, static_cast<std::int16_t>(std::lround(1000 * std::sin(angle)))),
        magnitude(extent, 2, 1000),
        mask(extent, 7, std::uint8_t{255}) {}
  GradientField field() const { return {x.view(), y.view(), magnitude.view()}; }
};

RefinedSegment refit(const support::EdgeScene& scene, const HoughSegment& rough,
                     const RefitOptions& options = {}) {
  RefinedSegment refined;
  REQUIRE(refit_segment(scene.mask, scene.field(), rough, options, refined) == Status::ok);
  return refined;
}

/// A dark bar from (20, 50) to (100, 50), `width` high, with a hole in it.
support::EdgeScene bar_with_hole(double width, double hole) {
  support::Canvas canvas(size);
  canvas.paint_bar({20, 50}, {100, 50}, width);
  canvas.paint_bar({60 - hole / 2, 50}, {60 + hole / 2, 50}, width + 2, 255);
  return support::EdgeScene(canvas.picture());
}

}  // namespace

TEST_CASE("the two edges of a thin bar are told apart by their light side") {
  const support::EdgeScene scene = bar_with_hole(4, 0);
  // Edges at v = 48 and v = 52: rows 47.5 and 51.5 counted from the first pixel's centre.
  const RefinedSegment upper = refit(scene, {25, 47, 95, 47});
  const RefinedSegment lower = refit(scene, {25, 52, 95, 52});
  REQUIRE(upper.pixels > 60);
  REQUIRE(lower.pixels > 60);
  CHECK(upper.light_y == Approx(-1).margin(1e-3));
  CHECK(lower.light_y == Approx(1).margin(1e-3));
  CHECK(upper.fit.centroid_y == Approx(47.5).margin(0.35));  // blur pushes the two apart
  CHECK(lower.fit.centroid_y == Approx(51.5).margin(0.35));
  CHECK(upper.fit.centroid_y + lower.fit.centroid_y == Approx(99).margin(0.05));
}

TEST_CASE("begin and end lie where the edge pixels end, begin first") {
  const support::EdgeScene scene = bar_with_hole(12, 0);
  const RefinedSegment edge = refit(scene, {40, 43, 80, 43});
  REQUIRE(edge.begin < edge.end);
  CHECK(edge.length() == Approx(80).margin(6));
  const double u0 = edge.fit.centroid_x - edge.begin * edge.light_y;
  const double u1 = edge.fit.centroid_x - edge.end * edge.light_y;
  CHECK(std::fmin(u0, u1) == Approx(19.5).margin(2.5));
  CHECK(std::fmax(u0, u1) == Approx(99.5).margin(2.5));
}

TEST_CASE("a hole longer than max_gap ends the segment") {
  const support::EdgeScene scene = bar_with_hole(12, 14);
  RefitOptions options;
  options.max_gap = 30;
  CHECK(refit(scene, {22, 43, 52, 43}, options).length() == Approx(80).margin(6));
  options.max_gap = 6;
  CHECK(refit(scene, {22, 43, 52, 43}, options).length() == Approx(33).margin(5));
}

TEST_CASE("an edge outside the corridor is left alone") {
  support::Canvas canvas(size);
  canvas.paint_box(0, 0, 120, 50);
  const support::EdgeScene scene(canvas.picture());
  CHECK(refit(scene, {20, 54, 100, 54}).pixels == 0);
  RefitOptions wide;
  wide.corridor = 8;
  const RefinedSegment found = refit(scene, {20, 54, 100, 54}, wide);
  REQUIRE(found.pixels > 80);
  CHECK(found.fit.centroid_y == Approx(49.5).margin(0.02));
}

TEST_CASE("a gradient across the segment's direction carries nothing") {
  EvenField even(size, 0);
  RefinedSegment refined;
  REQUIRE(refit_segment(even.mask.view(), even.field(), {20, 50, 100, 50}, {}, refined) == Status::ok);
  CHECK(refined.pixels == 0);
  REQUIRE(refit_segment(even.mask.view(), even.field(), {50, 20, 50, 80}, {}, refined) == Status::ok);
  CHECK(refined.pixels > 50);
}

TEST_CASE("with nothing near there are no pixels") {
  support::EdgeScene scene = bar_with_hole(6, 0);
  CHECK(refit(scene, {5, 5, 100, 5}).pixels == 0);
  scene.mask = Image<std::uint8_t>(size);
  CHECK(refit(scene, {25, 47, 95, 47}).pixels == 0);
}

TEST_CASE("a rough segment of one point, outside or far away is no accident") {
  const support::EdgeScene scene = bar_with_hole(6, 0);
  for (const HoughSegment& rough :
       {HoughSegment{60, 46, 60, 46}, HoughSegment{0, 0, 0, 0}, HoughSegment{-50, -50, -20, -50},
        HoughSegment{500, 400, 900, 500}, HoughSegment{-300, 47, 400, 47}, HoughSegment{60, -900, 60, 900},
        HoughSegment{119, 99, 119, 99}, HoughSegment{-100000, -100000, 100000, 100000}}) {
    CAPTURE(rough.x0, rough.y0, rough.x1, rough.y1);
    const RefinedSegment refined = refit(scene, rough);
    CHECK(std::isfinite(refined.fit.theta));
    CHECK((refined.pixels == 0 || refined.begin <= refined.end));
  }
}

TEST_CASE("bad options and views of refitting have a status each") {
  const support::EdgeScene scene = bar_with_hole(6, 0);
  const HoughSegment rough{25, 47, 95, 47};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto status = [&](const RefitOptions& options) {
    RefinedSegment refined;
    const Status result = refit_segment(scene.mask, scene.field(), rough, options, refined);
    CHECK((result == Status::ok || refined.pixels == 0));
    return result;
  };
  for (const double corridor : {nan, 0.49, 8.01, -1.0})
    CHECK(status({.corridor = corridor}) == Status::invalid_option);
  for (const double angle : {nan, -0.01, 1.58}) CHECK(status({.max_angle = angle}) == Status::invalid_option);
  for (const double gap : {nan, -1.0}) CHECK(status({.max_gap = gap}) == Status::invalid_option);
  for (const int rounds : {0, -3, 21}) CHECK(status({.rounds = rounds}) == Status::invalid_option);
  CHECK(status({.corridor = 0.5, .max_angle = 0, .max_gap = 0, .rounds = 1}) == Status::ok);
  CHECK(status({.corridor = 8, .max_angle = pi / 2, .max_gap = 100, .rounds = 20}) == Status::ok);
  RefinedSegment refined;
  CHECK(refit_segment({}, scene.field(), rough, {}, refined) == Status::invalid_image);
  CHECK(refit_segment(scene.mask, {}, rough, {}, refined) == Status::invalid_image);
  const Image<std::uint8_t> other({119, 100});
  CHECK(refit_segment(other, scene.field(), rough, {}, refined) == Status::size_mismatch);
}

TEST_CASE("claiming clears the segment's own pixels and no others") {
  for (int turn = 0; turn < 24; ++turn) {
    const double angle = turn * 15 * degree;
    CAPTURE(turn);
    EvenField even({60, 60}, angle);
    for (int i = 0; i < 60; ++i) {  // a stripe whose gradient points the other way
      even.x.at(30, i) = static_cast<std::int16_t>(-even.x.at(30, i));
      even.y.at(30, i) = static_cast<std::int16_t>(-even.y.at(30, i));
    }
    RefinedSegment segment;
    segment.light_x = std::cos(angle);
    segment.light_y = std::sin(angle);
    segment.fit.centroid_x = 28.3;
    segment.fit.centroid_y = 31.6;
    segment.begin = -9.3;
    segment.end = 12.2;
    const double corridor = 3.7, margin = 2;
    const std::uint32_t claimed =
        claim_pixels(even.mask.view(), even.field(), segment, corridor, 0.4, margin);
    std::uint32_t expected = 0, wrong = 0;
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {
        const double dx = x - 28.3, dy = y - 31.6;
        const double across = dx * segment.light_x + dy * segment.light_y;
        const double along = -dx * segment.light_y + dy * segment.light_x;
        const bool own = x != 30 && std::fabs(across) <= corridor && along >= segment.begin - margin &&
                         along <= segment.end + margin;
        expected += own ? 1 : 0;
        wrong += own == (even.mask.at(x, y) == 0) ? 0 : 1;
      }
    }
    CHECK(wrong == 0);
    CHECK(claimed == expected);
    CHECK(even.mask.guards_intact());
  }
}

TEST_CASE("claiming from a mask of another size, or from none, takes nothing") {
  EvenField even({20, 20}, 0);
  Image<std::uint8_t> other({21, 20}, 255);
  RefinedSegment segment;
  segment.end = 5;
  CHECK(claim_pixels(other.view(), even.field(), segment, 2, 0.5, 1) == 0);
  CHECK(claim_pixels({}, even.field(), segment, 2, 0.5, 1) == 0);
  CHECK(other == Image<std::uint8_t>({21, 20}, 255));
}

TEST_CASE("rows with gaps between them give the same segment") {
  const support::EdgeScene scene = bar_with_hole(5, 3);
  support::GuardedImage<std::uint8_t> mask(size, 9);
  support::GuardedImage<std::int16_t> x(size, 4), y(size, 6);
  support::GuardedImage<std::int32_t> magnitude(size, 1);
  for (int r = 0; r < size.height; ++r) {
    for (int c = 0; c < size.width; ++c) {
      mask.at(c, r) = scene.mask.at(c, r);
      x.at(c, r) = scene.field().x.at(c, r);
      y.at(c, r) = scene.field().y.at(c, r);
      magnitude.at(c, r) = scene.field().magnitude.at(c, r);
    }
  }
  const RefinedSegment tight = refit(scene, {25, 47, 95, 47});
  RefinedSegment gapped;
  REQUIRE(refit_segment(mask.view(), {x.view(), y.view(), magnitude.view()}, {25, 47, 95, 47}, {}, gapped) ==
          Status::ok);
  CHECK(gapped.pixels == tight.pixels);
  CHECK(gapped.fit.theta == tight.fit.theta);
  CHECK(gapped.fit.centroid_y == tight.fit.centroid_y);
  CHECK(gapped.begin == tight.begin);
  CHECK(gapped.end == tight.end);
}
