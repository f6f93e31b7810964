// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "cli/explain_accumulator.hpp"
#include "cli/explain_colours.hpp"
#include "cli/explain_geometry.hpp"
#include "cli/explain_pictures.hpp"
#include "cli/explain_progress.hpp"
#include "cli/explain_run.hpp"
#include "cli/explain_text.hpp"
#include "explained.hpp"

using namespace straightedge;
using namespace straightedge::cli;

namespace {

/// Black to the left of column 20, white from it on.
Image<std::uint8_t> upright_step() {
  Image<std::uint8_t> image(Size{48, 32});
  for (std::int32_t y = 0; y < 32; ++y) {
    for (std::int32_t x = 20; x < 48; ++x) image.at(x, y) = 255;
  }
  return image;
}

ExplainRun run_of(GrayView gray, LineMapOptions options = {.hough = line_map_hough}) {
  options.picture = PictureKind::photo;
  auto run = run_stages(gray, options);
  REQUIRE(run);
  return std::move(*run);
}

int brightness(Rgb colour) {
  return colour.red + colour.green + colour.blue;
}

}  // namespace

TEST_CASE("small pictures are enlarged by a whole factor, pixel by pixel") {
  const auto image = upright_step();
  const ExplainRun run = run_of(image);
  const PictureScale scale = scale_of(run, GradientNorm::l1);
  CHECK(scale.zoom == 640 / 48);
  const Image<Rgb> shown = show_gray(image, scale);
  REQUIRE(shown.size() == Size{48 * scale.zoom, 32 * scale.zoom});
  for (std::int32_t y = 0; y < shown.height(); ++y) {
    for (std::int32_t x = 0; x < shown.width(); ++x) {
      const std::uint8_t value = image.at(x / scale.zoom, y / scale.zoom);
      if (shown.at(x, y) != Rgb{value, value, value}) FAIL("at " << x << ", " << y);
    }
  }
}

TEST_CASE("gradients are shown around middle gray, lighter where it gets lighter") {
  const ExplainRun run = run_of(upright_step());
  const PictureScale scale = scale_of(run, GradientNorm::l1);
  const Image<Rgb> dx = show_signed(run.canny.gradient_x(), scale);
  const Image<Rgb> dy = show_signed(run.canny.gradient_y(), scale);
  const auto at = [&](std::int32_t pixel) { return pixel * scale.zoom + scale.zoom / 2; };
  CHECK(dx.at(at(5), at(16)) == Rgb{128, 128, 128});
  CHECK(dx.at(at(20), at(16)).red > 240);
  CHECK(dy.at(at(20), at(16)) == Rgb{128, 128, 128});

  Image<std::uint8_t> mirrored = upright_step();
  for (std::int32_t y = 0; y < 32; ++y) {
    for (std::int32_t x = 0; x < 48; ++x) mirrored.at(x, y) = x < 20 ? 255 : 0;
  }
  const ExplainRun other = run_of(mirrored);
  CHECK(show_signed(other.canny.gradient_x(), scale).at(at(20), at(16)).red < 16);
}

TEST_CASE("directions have the colours of the wheel") {
  const ExplainRun run = run_of(upright_step());
  const PictureScale scale = scale_of(run, GradientNorm::l1);
  const Rgb colour = show_direction(run, GradientNorm::l1, scale)
                         .at(20 * scale.zoom + scale.zoom / 2, 16 * scale.zoom + scale.zoom / 2);
  CHECK(colour.red > 200);
  CHECK(colour.green < 40);
  CHECK(colour.blue < 40);
  const Image<Rgb> wheel = direction_wheel();
  const std::int32_t middle = wheel.width() / 2, rim = wheel.width() - 16;
  const Rgb right = wheel.at(rim, middle), down = wheel.at(middle, rim);
  CHECK(right.red > 240);
  CHECK(right.green < 30);
  CHECK(down.green > 240);
  CHECK(down.blue < 30);
}

TEST_CASE("the heat map gets brighter with every vote") {
  int last = -1;
  for (int i = 0; i <= 100; ++i) {
    const int now = brightness(heat(i / 100.0));
    CHECK(now > last);
    last = now;
  }
}

TEST_CASE("the only line of a picture is the peak of the accumulator") {
  const ExplainRun run = run_of(upright_step());
  REQUIRE(run.peaks.size() == 1);
  CHECK(run.peaks[0].theta == 0.0F);
  CHECK((run.peaks[0].rho == 19.0F || run.peaks[0].rho == 20.0F));
  CHECK(run.peaks[0].votes == 32);
  const AccumulatorPicture shown = show_accumulator(run);
  CHECK(shown.most_votes == 32);
  std::int32_t ringed = 0;
  for (std::int32_t y = 0; y < shown.picture.height(); ++y) {
    for (std::int32_t x = 0; x < shown.picture.width(); ++x)
      ringed += shown.picture.at(x, y) == marker_colour;
  }
  CHECK(ringed > 20);
}

TEST_CASE("the progress ends where the run ends") {
  LineMapOptions options{.hough = line_map_hough};
  options.hough->method = GENERATE(HoughMethod::progressive, HoughMethod::randomized);
  const ExplainRun run = run_of(explained::fixture("images/blox.jpg"), options);
  const auto pictures = show_progress(run, first_round(options), {.zoom = 1, .full_length = 1});
  REQUIRE(pictures.size() == 4);
  CHECK(pictures[0].lines == 1);
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    CHECK(pictures[i].lines > pictures[i - 1].lines);
    CHECK(pictures[i].votes >= pictures[i - 1].votes);
    CHECK(pictures[i].left < pictures[i - 1].left);
  }
  const bool pairs = options.hough->method == HoughMethod::randomized;
  CHECK(pictures.back().lines == (pairs ? run.hough.peaks : run.hough.segments));
  for (const ProgressPicture& moment : pictures) {
    std::uint32_t taken = 0, others = 0;
    for (std::int32_t y = 0; y < moment.picture.height(); ++y) {
      for (std::int32_t x = 0; x < moment.picture.width(); ++x) {
        taken += moment.picture.at(x, y) == taken_colour;
        others += moment.picture.at(x, y) == strong_colour || moment.picture.at(x, y) == waiting_colour;
      }
    }
    CHECK(others == moment.left);
    CHECK(taken + others == run.hough.edge_pixels);
  }
}

TEST_CASE("in a large picture of the progress a pixel is a dot") {
  Image<std::uint8_t> image(Size{1200, 40});
  for (std::int32_t y = 20; y < 40; ++y) {
    for (std::int32_t x = 0; x < 1200; ++x) image.at(x, y) = 255;
  }
  const ExplainRun run = run_of(image);
  const auto pictures = show_progress(run, line_map_hough, scale_of(run, GradientNorm::l1));
  REQUIRE_FALSE(pictures.empty());
  std::int32_t rows = 0;
  for (std::int32_t y = 0; y < 40; ++y) rows += pictures.back().picture.at(600, y) == taken_colour;
  CHECK(rows == 3);
}

TEST_CASE("chords end at the picture's border") {
  const Size size{100, 60};
  const auto upright = chord_of({.rho = 30, .theta = 0, .votes = 1}, size);
  REQUIRE(upright);
  CHECK(std::abs(upright->from.y - upright->to.y) == Approx(60));
  CHECK(upright->from.x == Approx(30));
  const auto slanting = chord_of({.rho = 40, .theta = 0.7F, .votes = 1}, size);
  REQUIRE(slanting);
  CHECK(distance_to({.rho = 40, .theta = 0.7F, .votes = 1}, slanting->from) < 1e-5);
  CHECK(distance_to({.rho = 40, .theta = 0.7F, .votes = 1}, slanting->to) < 1e-5);
  CHECK_FALSE(chord_of({.rho = 130, .theta = 0.1F, .votes = 1}, size));
}

TEST_CASE("letters are drawn where they should and cut at the border") {
  Image<Rgb> image(Size{40, 12});
  draw_text(image.view(), "1-", {.x = 2, .y = 1, .scale = 1, .colour = {9, 9, 9}});
  CHECK(image.at(4, 1) == Rgb{9, 9, 9});
  CHECK(image.at(2, 1) == Rgb{});
  for (std::int32_t x = 8; x < 13; ++x) CHECK(image.at(x, 4) == Rgb{9, 9, 9});
  CHECK(text_size("1-", 1) == Size{11, 7});
  draw_text(image.view(), "888", {.x = 36, .y = -3, .scale = 4, .colour = {1, 2, 3}});
  CHECK(image.at(36, 3) == Rgb{1, 2, 3});
}
