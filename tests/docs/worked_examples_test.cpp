// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The examples that the pages in docs/ work out by hand, done by the library. Whoever changes a number here
// changes it there.
#include <array>
#include <cstddef>
#include <vector>

#include "straightedge/gaussian.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/hough_lines.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// An image of five by five.
template <class T>
Image<T> values(const std::array<T, 25>& rows) {
  Image<T> image(Size{5, 5});
  for (std::int32_t i = 0; i < 25; ++i) image.at(i % 5, i / 5) = rows[static_cast<std::size_t>(i)];
  return image;
}

struct Stages {
  Image<std::int16_t> dx, dy;
  Image<std::int32_t> magnitude;
  Image<std::uint8_t> classes;
};

Stages stages_of(const Image<std::uint8_t>& patch) {
  const Size size = patch.size();
  Stages s{Image<std::int16_t>(size), Image<std::int16_t>(size), Image<std::int32_t>(size),
           Image<std::uint8_t>(size)};
  std::array<std::int16_t, 16> sums{}, differences{};
  REQUIRE(sobel(patch, 3, Border::replicate, GradientScale::clamp, {sums, differences}, s.dx.view(),
                s.dy.view()) == Status::ok);
  REQUIRE(gradient_magnitude(s.dx, s.dy, GradientNorm::l1, s.magnitude.view()) == Status::ok);
  REQUIRE(suppress_non_maxima(s.dx, s.dy, s.magnitude, 50, 150, s.classes.view()) == Status::ok);
  return s;
}

/// Three pixels on the line x + y = 8.
Image<std::uint8_t> three_pixels() {
  Image<std::uint8_t> image(Size{9, 9});
  image.at(2, 6) = image.at(4, 4) = image.at(6, 2) = 255;
  return image;
}

constexpr double eighth = pi / 4;

}  // namespace

TEST_CASE("edges.md: the kernel of sigma 1.4") {
  std::array<std::uint16_t, 9> taps{};
  REQUIRE(gaussian_size(1.4) == 9);
  REQUIRE(make_gaussian_kernel(1.4, taps) == Status::ok);
  CHECK(taps == std::array<std::uint16_t, 9>{1, 8, 26, 56, 74, 56, 26, 8, 1});
}

TEST_CASE("edges.md: gradient and suppression of a patch of five by five") {
  const auto patch = values<std::uint8_t>({10, 10, 10, 90, 90,  //
                                           10, 10, 10, 90, 90,  //
                                           10, 10, 50, 90, 90,  //
                                           10, 10, 90, 90, 90,  //
                                           10, 50, 90, 90, 90});
  const Stages s = stages_of(patch);
  CHECK(s.dx.at(2, 2) == 320);
  CHECK(s.dy.at(2, 2) == 160);
  CHECK(s.magnitude.at(2, 2) == 480);
  CHECK(gradient_sector(320, 160) == GradientSector::falling);
  CHECK(s.magnitude.at(1, 1) == 80);
  CHECK(s.magnitude.at(3, 3) == 80);
  CHECK(s.classes.at(2, 2) == strong_edge);
  CHECK(s.classes.at(1, 1) == no_edge);
  CHECK(s.classes.at(3, 3) == no_edge);
  CHECK(s.magnitude == values<std::int32_t>({0,   0,   320, 320, 0,  //
                                             0,   80,  400, 320, 0,  //
                                             0,   240, 480, 240, 0,  //
                                             80,  400, 400, 80,  0,  //
                                             160, 400, 240, 0,   0}));
  CHECK(s.classes == values<std::uint8_t>({0, 0, 2, 0, 0,  //
                                           0, 0, 2, 0, 0,  //
                                           0, 0, 2, 0, 0,  //
                                           0, 2, 2, 0, 0,  //
                                           0, 2, 0, 0, 0}));
}

TEST_CASE("hough-standard.md: three pixels vote for four angles") {
  HoughOptions options{.method = HoughMethod::standard, .theta_step = eighth, .threshold = 2};
  std::vector<std::byte> memory(HoughLines::workspace_bytes({9, 9}, options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, {9, 9}, options, memory) == Status::ok);
  std::array<HoughPeak, 4> peaks;
  const HoughResult result = lines.run(three_pixels(), peaks, {});
  const auto cells = lines.accumulator();
  REQUIRE(cells.height == 4);
  const std::int32_t zero = (cells.width - 1) / 2;
  const auto votes = [&](std::int32_t angle, std::int32_t rho) { return cells.at(zero + rho, angle); };
  CHECK(votes(0, 2) == 1);
  CHECK(votes(0, 4) == 1);
  CHECK(votes(0, 6) == 1);
  CHECK(votes(1, 6) == 3);
  CHECK(votes(2, 2) == 1);
  CHECK(votes(2, 4) == 1);
  CHECK(votes(2, 6) == 1);
  CHECK(votes(3, 3) == 1);
  CHECK(votes(3, 0) == 1);
  CHECK(votes(3, -3) == 1);
  REQUIRE(result.peaks == 1);
  CHECK(peaks[0].rho == 6.0F);
  CHECK(peaks[0].votes == 3);
}

TEST_CASE("hough-progressive.md: two votes are enough, the third pixel is taken") {
  HoughOptions options{.method = HoughMethod::progressive,
                       .theta_step = eighth,
                       .threshold = 2,
                       .min_length = 4,
                       .max_gap = 3};
  std::vector<HoughStep> steps;
  const HoughTrace trace{[](void* user, const HoughEvent& event) {
                           static_cast<std::vector<HoughStep>*>(user)->push_back(event.step);
                           return true;
                         },
                         &steps};
  std::vector<std::byte> memory(HoughLines::workspace_bytes({9, 9}, options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, {9, 9}, options, memory) == Status::ok);
  std::array<HoughSegment, 4> segments;
  const HoughResult result = lines.run(three_pixels(), {}, segments, trace);
  using enum HoughStep;
  CHECK(steps == std::vector<HoughStep>{vote, vote, removal, removal, removal, line});
  REQUIRE(result.segments == 1);
  CHECK(segments[0].votes == 2);
  CHECK(segments[0].pixels == 3);
  const auto cells = lines.accumulator();
  for (std::int32_t n = 0; n < cells.height; ++n) {
    for (std::int32_t r = 0; r < cells.width; ++r) CHECK(cells.at(r, n) == 0);
  }
}

TEST_CASE("hough-randomized.md: a pair of pixels casts one vote") {
  HoughOptions options{.method = HoughMethod::randomized, .theta_step = eighth, .min_length = 100};
  options.pair_min_distance = 2;
  options.pair_radius = 4;
  options.pair_threshold = 100;
  options.max_draws = 1;
  std::vector<std::byte> memory(HoughLines::workspace_bytes({9, 9}, options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, {9, 9}, options, memory) == Status::ok);
  // The seed decides whether the only draw is a pair; the vote of a pair is always the same.
  for (options.seed = 1; options.seed < 50; ++options.seed) {
    REQUIRE(HoughLines::prepare(lines, {9, 9}, options, memory) == Status::ok);
    REQUIRE(lines.run(three_pixels(), {}, {}).status == Status::ok);
    const auto cells = lines.accumulator();
    const std::int32_t vote = cells.at((cells.width - 1) / 2, 1);
    std::int32_t all = 0;
    for (std::int32_t n = 0; n < cells.height; ++n) {
      for (std::int32_t r = 0; r < cells.width; ++r) all += cells.at(r, n);
    }
    CHECK(all == vote);
    if (vote == 1) return;
  }
  FAIL("no seed draws a pair");
}
