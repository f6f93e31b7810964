// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

/// Gradients along random directions.
struct RandomGradient {
  Image<std::int16_t> dx;
  Image<std::int16_t> dy;
  RandomGradient(Size size, std::uint64_t seed) : dx(size), dy(size) {
    Pcg32 random(seed);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        dx.at(x, y) = static_cast<std::int16_t>(static_cast<int>(random.below(201)) - 100);
        dy.at(x, y) = static_cast<std::int16_t>(static_cast<int>(random.below(201)) - 100);
      }
    }
  }
};

struct After {
  std::int64_t sum = 0;
  std::int32_t least = 0;
  std::int64_t voters = 0;
  std::uint32_t segments = 0;
};

After run(const EdgeImage& image, const HoughOptions& options, GradientView gradients = {}) {
  std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, image.size(), options, memory) == Status::ok);
  std::vector<HoughSegment> segments(5000);
  const HoughResult result = lines.run(image, gradients, {}, segments);
  REQUIRE(result.status == Status::ok);
  After after;
  after.segments = result.segments;
  const auto cells = lines.accumulator();
  for (int n = 0; n < cells.height; ++n) {
    for (int r = 0; r < cells.width; ++r) {
      after.sum += cells.at(r, n);
      after.least = std::min(after.least, cells.at(r, n));
    }
  }
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) after.voters += lines.remaining().at(x, y) ? 1 : 0;
  return after;
}

HoughOptions short_lines(std::uint64_t seed) {
  HoughOptions options;
  options.threshold = 8;
  options.min_length = 8;
  options.max_gap = 3;
  options.seed = seed;
  return options;
}

}  // namespace

TEST_CASE("what is left in the accumulator is the votes of the pixels that are left") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    const EdgeImage image = test::noise({90, 70}, 0.15, seed);
    const After after = run(image, short_lines(seed));
    CHECK(after.segments > 10);
    CHECK(after.least == 0);
    CHECK(after.sum == after.voters * 180);
  }
}

TEST_CASE("with a gradient window, too, votes come off as they were cast") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    const EdgeImage image = test::noise({90, 70}, 0.3, seed);
    const RandomGradient gradient(image.size(), seed);
    HoughOptions options = short_lines(seed);
    options.threshold = 4;
    options.gradient_window = 0.2;
    options.theta_step = 0.02;  // does not divide pi
    const After after = run(image, options, {gradient.dx.view(), gradient.dy.view()});
    CHECK(after.segments > 10);
    CHECK(after.least == 0);
    // round(2 * 0.2 / 0.02) + 1 angles each, all of the 157 where the gradient is null.
    CHECK(after.sum >= after.voters * 21);
    CHECK(after.sum <= after.voters * 21 + 136 * 5);
  }
}

TEST_CASE("following OpenCV, votes that were never cast come off as well") {
  bool below_zero = false;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    HoughOptions options = short_lines(seed);
    options.generator = HoughGenerator::opencv;
    below_zero = below_zero || run(test::noise({90, 70}, 0.15, seed), options).least < 0;
  }
  CHECK(below_zero);
}

TEST_CASE("seeds differ, but each finds the lines of a clean drawing") {
  EdgeImage image({200, 150});
  test::draw(image, 10, 10, 180, 60);
  test::draw(image, 30, 140, 170, 20);
  test::draw(image, 100, 5, 100, 145);
  bool different = false;
  std::vector<HoughSegment> first;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    HoughOptions options;
    options.seed = seed;
    options.threshold = 40;
    options.max_gap = 20;
    const auto found = hough_lines(image, options).segments;
    double together = 0;
    for (const HoughSegment& s : found) together += test::length(s);
    INFO("seed " << seed);
    CHECK(found.size() >= 3);
    CHECK(together > 0.85 * (177 + 184 + 140));
    if (seed == 1) first = found;
    different = different || found != first;
  }
  CHECK(different);
}

TEST_CASE("no pixel serves two segments") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    const EdgeImage image = test::noise({90, 70}, 0.15, seed);
    const HoughFound found = hough_lines(image, short_lines(seed));
    std::int64_t pixels = 0;
    for (const HoughSegment& s : found.segments) {
      pixels += s.pixels;
      CHECK(s.votes >= 8);
      CHECK(test::length(s) >= 8);
      CHECK(image.at(s.x0, s.y0) != 0);
      CHECK(image.at(s.x1, s.y1) != 0);
    }
    CHECK(pixels <= found.result.edge_pixels);
  }
}
