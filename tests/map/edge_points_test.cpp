// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_points.hpp"

#include <cstdint>
#include <vector>

#include "straightedge/random.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

/// Walls and noise: corridors find edges of several lines, and chance pixels.
Image<std::uint8_t> crowded_picture(Size size, Pcg32& random) {
  support::Canvas canvas(size);
  canvas.paint_box(10, 12, size.width - 20, 15);
  canvas.paint_box(30, 5, 33, size.height - 4);
  canvas.paint_box(60, 30, 100, 62);
  Image<std::uint8_t> picture = canvas.picture();
  for (std::int32_t x = 0; x < size.width; ++x) {
    const std::int32_t y = size.height - 10 - x / 3;
    for (std::int32_t k = 0; k < 3 && y + k < size.height; ++k)
      if (y + k >= 0) picture.at(x, y + k) = 0;
  }
  for (int k = 0; k < 150; ++k)
    picture.at(static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(size.width))),
               static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(size.height)))) = 90;
  return picture;
}

void check_equal(const LineMoments& a, const LineMoments& b) {
  REQUIRE(a.weight == b.weight);
  REQUIRE(a.x == b.x);
  REQUIRE(a.y == b.y);
  REQUIRE(a.xx == b.xx);
  REQUIRE(a.xy == b.xy);
  REQUIRE(a.yy == b.yy);
  REQUIRE(a.count == b.count);
}

void check_equal(const RefinedSegment& a, const RefinedSegment& b) {
  check_equal(a.moments, b.moments);
  REQUIRE(a.light_x == b.light_x);
  REQUIRE(a.light_y == b.light_y);
  REQUIRE(a.fit.centroid_x == b.fit.centroid_x);
  REQUIRE(a.fit.centroid_y == b.fit.centroid_y);
  REQUIRE(a.begin == b.begin);
  REQUIRE(a.end == b.end);
  REQUIRE(a.pixels == b.pixels);
}

std::vector<HoughSegment> rough_segments(Size size, Pcg32& random) {
  std::vector<HoughSegment> rough{{10, 12, size.width - 21, 12, 1, 1},
                                  {30, 5, 30, size.height - 5, 1, 1},
                                  {60, 30, 99, 31, 1, 1},
                                  {62, 61, 90, 62, 1, 1},
                                  {0, size.height - 10, 90, size.height - 40, 1, 1}};
  const auto below = [&](std::int32_t most) {
    return static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(most)));
  };
  for (int k = 0; k < 60; ++k)
    rough.push_back({below(size.width), below(size.height), below(size.width), below(size.height), 1, 1});
  return rough;
}

bool same_mask(GrayView a, GrayView b) {
  for (std::int32_t y = 0; y < a.height; ++y)
    for (std::int32_t x = 0; x < a.width; ++x)
      if (a.at(x, y) != b.at(x, y)) return false;
  return true;
}

}  // namespace

TEST_CASE("edge points refit and claim as the mask and the field do, bit for bit, in every set") {
  Pcg32 random(5);
  for (const Size size : {Size{160, 120}, Size{131, 97}, Size{128, 64}}) {
    CAPTURE(size.width);
    const support::EdgeScene scene(crowded_picture(size, random));
    const std::vector<HoughSegment> rough = rough_segments(size, random);
    for (const KernelSet& set : kernel_sets()) {
      for (const bool own_magnitude : {false, true}) {
        CAPTURE(set.name, own_magnitude);
        GradientField given = scene.field();
        if (own_magnitude) given.magnitude = {};
        EdgePoints points;
        points.find(scene.mask, given, GradientNorm::l1, set);
        Image<std::uint8_t> mask = scene.mask;
        REQUIRE(same_mask(points.mask(), mask));
        std::uint32_t pixels = 0, claimed = 0;
        for (const HoughSegment& segment : rough) {
          RefinedSegment expected, found;
          REQUIRE(refit_segment(mask, scene.field(), segment, {}, expected) == Status::ok);
          REQUIRE(refitting::refit(points, segment, {}, found) == Status::ok);
          check_equal(found, expected);
          pixels += expected.pixels;
          if (expected.pixels < 12) continue;
          claimed += claim_pixels(mask.view(), scene.field(), expected, 2.2, 0.7, 1.5);
          refitting::claim(points, found, 2.2, 0.7, 1.5);
          REQUIRE(same_mask(points.mask(), mask));
        }
        CHECK(pixels > 300);
        CHECK(claimed > 200);
      }
    }
  }
}

TEST_CASE("edge points take the squared norm, and pictures of another size one after the other") {
  Pcg32 random(6);
  EdgePoints points;
  for (const Size size : {Size{200, 90}, Size{120, 130}, Size{200, 90}}) {
    CannyOptions options{.low = 60, .high = 120};
    options.norm = GradientNorm::l2;
    const support::EdgeScene scene(crowded_picture(size, random), options);
    points.find(scene.mask, GradientField{scene.field().x, scene.field().y, {}}, GradientNorm::l2,
                best_kernels());
    const HoughSegment segment{12, 12, size.width - 25, 12, 1, 1};
    RefinedSegment expected, found;
    REQUIRE(refit_segment(scene.mask, scene.field(), segment, {}, expected) == Status::ok);
    REQUIRE(refitting::refit(points, segment, {}, found) == Status::ok);
    CHECK(expected.pixels > 50);
    check_equal(found, expected);
  }
}
