// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>

#include "draw_plan.hpp"

using namespace straightedge;
using plan::Found;
using plan::Wall;

namespace {

constexpr Size size{200, 160};

/// A room of thin walls with a thick one in it.
support::Canvas room() {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 30}, {170, 30}, 2.4);
  canvas.paint_bar({30, 130}, {170, 130}, 2.4);
  canvas.paint_bar({30, 28.8}, {30, 131.2}, 2.4);
  canvas.paint_bar({170, 28.8}, {170, 131.2}, 2.4);
  canvas.paint_bar({60, 60}, {140, 100}, 9);
  return canvas;
}

Image<std::uint8_t> negative(const Image<std::uint8_t>& image) {
  Image<std::uint8_t> out(image.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) out.at(x, y) = static_cast<std::uint8_t>(255 - image.at(x, y));
  }
  return out;
}

void check_refused(const LineMapOptions& options) {
  const auto result = build_line_map(room().picture(), options);
  REQUIRE_FALSE(static_cast<bool>(result));
  CHECK(result.failure().problem == Problem::bad_option);
  CHECK(result.failure().sentence.size() > 10);
}

}  // namespace

TEST_CASE("pictures with nothing in them give an empty map") {
  for (const Size extent : {Size{1, 1}, Size{1, 50}, Size{50, 1}, Size{2, 2}, Size{3, 7}, Size{64, 48}}) {
    for (const int level : {0, 1, 127, 205, 254, 255}) {
      for (const PictureKind kind : {PictureKind::automatic, PictureKind::map, PictureKind::photo}) {
        CAPTURE(extent.width, extent.height, level);
        const Image<std::uint8_t> picture(extent, static_cast<std::uint8_t>(level));
        LineMapOptions options;
        options.picture = kind;
        const LineMapResult result = plan::build(picture, options);
        CHECK(result.map.lines.empty());
        CHECK(result.report.segments == 0);
        REQUIRE(result.map.image.has_value());
        CHECK(result.map.image->size == extent);
      }
    }
  }
}

TEST_CASE("tiny pictures of noise are no accident") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 51);
    const Size extent{1 + static_cast<int>(random.below(24)), 1 + static_cast<int>(random.below(24))};
    Image<std::uint8_t> picture(extent);
    for (int y = 0; y < extent.height; ++y) {
      for (int x = 0; x < extent.width; ++x) picture.at(x, y) = static_cast<std::uint8_t>(random.below(256));
    }
    LineMapOptions options;
    options.picture = seed % 2 == 0 ? PictureKind::map : PictureKind::photo;
    if (seed % 3 == 0) options.meaning = RosMeaning{};
    plan::build(picture, options);
  }
}

TEST_CASE("no picture is a failure with a sentence") {
  const auto result = build_line_map({}, {});
  REQUIRE_FALSE(static_cast<bool>(result));
  CHECK(result.failure().sentence.size() > 10);
}

TEST_CASE("options out of range are refused with a sentence") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuse = [](double LineMapOptions::*option, double value) {
    CAPTURE(value);
    LineMapOptions options;
    options.*option = value;
    check_refused(options);
  };
  for (const double bad : {nan, -1.0, 2.9, 1e7}) refuse(&LineMapOptions::min_length, bad);
  for (const double bad : {nan, -0.1, 1e7}) refuse(&LineMapOptions::max_gap, bad);
  for (const double bad : {nan, -0.1, 50.5}) refuse(&LineMapOptions::max_wall_width, bad);
  for (const double bad : {nan, -0.1, 1e7}) refuse(&LineMapOptions::furniture_size, bad);
  LineMapOptions canny;
  canny.canny.low = 200;
  check_refused(canny);
  canny.canny.low = nan;
  check_refused(canny);
  LineMapOptions hough{.hough = line_map_hough};
  hough.hough->threshold = 0;
  check_refused(hough);
  hough.hough = line_map_hough;
  hough.hough->rho_step = nan;
  check_refused(hough);
}

TEST_CASE("a picture with a side above 32767 pixels is refused, however straight edges are found") {
  for (const Size wide : {Size{32768, 1}, Size{1, 32768}}) {
    const Image<std::uint8_t> picture(wide, 255);
    for (const LineMapOptions& options : {LineMapOptions{}, LineMapOptions{.hough = line_map_hough}}) {
      const auto result = build_line_map(picture, options);
      REQUIRE_FALSE(static_cast<bool>(result));
      CHECK(result.failure().problem == Problem::bad_option);
      CHECK(result.failure().sentence.find("too large") != std::string::npos);
    }
  }
  plan::build(Image<std::uint8_t>(Size{32767, 1}, 255), {});
}

TEST_CASE("thresholds that no map file may have are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuse = [](const RosMeaning& meaning) {
    CAPTURE(meaning.occupied_thresh, meaning.free_thresh);
    LineMapOptions options;
    options.meaning = meaning;
    check_refused(options);
  };
  for (const double bad : {nan, -0.1, 1.1}) {
    refuse({.occupied_thresh = bad});
    refuse({.free_thresh = bad});
  }
  refuse({.occupied_thresh = 0.3, .free_thresh = 0.5});
}

TEST_CASE("bright walls on dark ground give the same map where the map says negate") {
  const Image<std::uint8_t> picture = room().picture();
  LineMapOptions plain, negated;
  plain.meaning = RosMeaning{};
  negated.meaning = RosMeaning{.negate = true};
  const LineMap map = plan::build(picture, plain).map;
  REQUIRE(map.lines.size() >= 6);
  CHECK(plan::build(negative(picture), negated).map.lines == map.lines);
}

TEST_CASE("the same picture twice gives equal maps") {
  support::Canvas canvas = room();
  Pcg32 random(3, 52);
  canvas.add_noise(6, random);
  const Image<std::uint8_t> picture = canvas.picture();
  for (const LineMapOptions& options : plan::all_methods())
    CHECK(plan::build(picture, options).map == plan::build(picture, options).map);
}

TEST_CASE("the map is written and read back unchanged") {
  const LineMap map = plan::build(room().picture()).map;
  const auto text = line_map_to_xml(map);
  REQUIRE(static_cast<bool>(text));
  const auto back = line_map_from_xml(*text, "room.xml");
  REQUIRE(static_cast<bool>(back));
  CHECK(*back == map);
}

TEST_CASE("ids count from zero, counts of the report are those of the map") {
  const LineMapResult result = plan::build(room().picture());
  std::uint32_t lines = 0, segments = 0;
  for (const MapLine& line : result.map.lines) {
    CHECK(line.id == lines++);
    REQUIRE_FALSE(line.segments.empty());
    for (const MapSegment& segment : line.segments) {
      CHECK(segment.id == segments++);
      CHECK(segment.pixels.value_or(0) > 0);
    }
    CHECK(line.votes.value_or(0) > 0);
    CHECK(line.count.value_or(0) > 0);
    REQUIRE(line.covariance.has_value());
    CHECK(line.covariance->var_theta > 0);
    CHECK(line.covariance->var_offset >= 0.05 * 0.05);  // the smallest floor
  }
  CHECK(result.report.lines == lines);
  CHECK(result.report.segments == segments);
  CHECK(result.report.picture == PictureKind::map);
  CHECK(result.report.walls >= 4);
  CHECK(result.report.edges >= segments);
  CHECK(result.report.candidates == result.report.edges);
  CHECK(result.report.rounds == 0);
  const LineMapResult voted = plan::build(room().picture(), {.hough = line_map_hough});
  CHECK(voted.report.candidates >= voted.report.edges);
  CHECK(voted.report.rounds >= 1);
  CHECK(voted.report.segments == segments);
}

TEST_CASE("a photo keeps every edge and knows no walls") {
  support::Canvas canvas(size, 160);
  canvas.paint_bar({30, 60}, {170, 60}, 3, 20);
  canvas.paint_box(60, 90, 140, 130, 250);
  LineMapOptions options;
  options.picture = PictureKind::photo;
  const std::vector<Found> found = plan::walls_in(canvas, options);
  for (const Found& f : found) CHECK_FALSE(f.line.width.has_value());
  CHECK(plan::beside(found, {{30, 58.5}, {170, 58.5}}).size() == 1);
  CHECK(plan::beside(found, {{30, 61.5}, {170, 61.5}}).size() == 1);
  for (const Wall& side : {Wall{{60, 90}, {140, 90}}, Wall{{60, 130}, {140, 130}}, Wall{{60, 90}, {60, 130}},
                           Wall{{140, 90}, {140, 130}}}) {
    CHECK(plan::beside(found, side).size() == 1);
  }
  CHECK(found.size() == 6);
}

TEST_CASE("open floor is told from unknown space") {
  // Unknown above the wall, floor below it.
  support::Canvas canvas(size, 254);
  canvas.paint_box(0, 0, 200, 80, 205);
  SECTION("thin wall") {
    canvas.paint_bar({30, 80}, {170, 80}, 2.6);
    for (const bool with_meaning : {false, true}) {
      CAPTURE(with_meaning);
      LineMapOptions options;
      if (with_meaning) options.meaning = RosMeaning{};
      const std::vector<Found> found = plan::walls_in(canvas, options);
      REQUIRE(found.size() == 1);
      CHECK(found[0].line.free ==
            (plan::on_plus_side(found[0].line, {100, 120}, size) ? FreeSide::plus : FreeSide::minus));
    }
  }
  SECTION("the face towards unknown space has no free side") {
    canvas.paint_bar({30, 80}, {170, 80}, 10);
    const std::vector<Found> found = plan::walls_in(canvas);
    const auto upper = plan::beside(found, {{30, 75}, {170, 75}});
    const auto lower = plan::beside(found, {{30, 85}, {170, 85}});
    REQUIRE(upper.size() == 1);
    REQUIRE(lower.size() == 1);
    CHECK(upper[0].line.free == FreeSide::unknown);
    CHECK(lower[0].line.free ==
          (plan::on_plus_side(lower[0].line, {100, 120}, size) ? FreeSide::plus : FreeSide::minus));
  }
}

TEST_CASE("the border of unknown space and laser rays are no walls") {
  support::Canvas canvas(size, 205);
  canvas.paint_box(20, 40, 150, 140, 254);
  for (int i = 0; i < 6; ++i) canvas.paint_bar({140, 60.0 + 12 * i}, {195, 20.0 + 26 * i}, 1, 254);
  canvas.paint_bar({40, 60}, {120, 60}, 2.4);
  for (const bool with_meaning : {false, true}) {
    CAPTURE(with_meaning);
    LineMapOptions options;
    if (with_meaning) options.meaning = RosMeaning{};
    const std::vector<Found> found = plan::walls_in(canvas, options);
    CHECK(found.size() == 1);
    CHECK(plan::beside(found, {{40, 60}, {120, 60}}).size() == 1);
  }
}
