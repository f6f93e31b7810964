// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

struct Ends {
  int x0, y0, x1, y1;
};

constexpr Ends drawing[] = {
    {20, 20, 280, 20},  {20, 40, 20, 220},   {60, 60, 200, 200},  {280, 50, 180, 223},  {40, 230, 170, 210},
    {230, 30, 262, 38}, {100, 40, 130, 100}, {60, 215, 100, 120}, {290, 100, 292, 200}, {150, 60, 250, 65}};

EdgeImage noisy_drawing(std::uint64_t seed) {
  EdgeImage image = test::noise({300, 240}, 0.01, seed);
  for (const Ends& e : drawing) test::draw(image, e.x0, e.y0, e.x1, e.y1);
  return image;
}

HoughOptions randomized(std::uint64_t seed) {
  HoughOptions options;
  options.method = HoughMethod::randomized;
  options.max_gap = 5;
  options.seed = seed;
  return options;
}

/// The share of the drawn line's pixels that lie beside a segment found, 1.5 pixels at most.
double covered(const Ends& e, const std::vector<HoughSegment>& found) {
  const int steps = std::max(std::abs(e.x1 - e.x0), std::abs(e.y1 - e.y0));
  int hits = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = e.x0 + (e.x1 - e.x0) * static_cast<double>(i) / steps;
    const double y = e.y0 + (e.y1 - e.y0) * static_cast<double>(i) / steps;
    hits += std::any_of(found.begin(), found.end(), [&](const HoughSegment& s) {
      const double length = test::length(s);
      const double along = ((x - s.x0) * (s.x1 - s.x0) + (y - s.y0) * (s.y1 - s.y0)) / length;
      const double across = ((x - s.x0) * (s.y1 - s.y0) - (y - s.y0) * (s.x1 - s.x0)) / length;
      return std::fabs(across) < 1.5 && along > -1.5 && along < length + 1.5;
    });
  }
  return static_cast<double>(hits) / (steps + 1);
}

}  // namespace

TEST_CASE("all lines of a noisy drawing are found, once, for every seed") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const HoughFound found = hough_lines(noisy_drawing(seed), randomized(seed));
    INFO("seed " << seed);
    CHECK(found.result.status == Status::ok);
    for (const Ends& e : drawing) {
      INFO(e.x0 << ", " << e.y0 << " to " << e.x1 << ", " << e.y1);
      CHECK(covered(e, found.segments) > 0.9);
    }
    CHECK(found.segments.size() <= std::size(drawing) + 2);
  }
}

TEST_CASE("the stated confidence is reached when there is time, and not claimed otherwise") {
  EdgeImage image = test::noise({150, 120}, 0.01, 8);
  test::draw(image, 20, 20, 130, 90);
  HoughOptions options = randomized(4);
  options.max_draws = 10'000'000;
  const HoughFound patient = hough_lines(image, options);
  CHECK(patient.result.confident);
  CHECK(patient.result.draws < 10'000'000);
  CHECK(patient.segments.size() == 1);
  options.max_draws = 20;
  const HoughFound hasty = hough_lines(image, options);
  CHECK_FALSE(hasty.result.confident);
  CHECK(hasty.result.draws == 20);
}

TEST_CASE("a line of the least length is missed no more often than stated") {
  // 40 drawings, stated chance of a miss 1 in 10: more than 10 misses have a chance below 0.002.
  int misses = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EdgeImage image = test::noise({200, 160}, 0.01, seed);
    Pcg32 random(seed, 1);
    const int x = 10 + static_cast<int>(random.below(140));
    const int y = 10 + static_cast<int>(random.below(120));
    const int rise = static_cast<int>(random.below(31));
    const Ends line{x, y, x + 31, y + rise};
    test::draw(image, line.x0, line.y0, line.x1, line.y1);
    HoughOptions options = randomized(seed);
    options.confidence = 0.9;
    options.max_draws = 100'000'000;
    const HoughFound found = hough_lines(image, options);
    REQUIRE(found.result.confident);
    misses += covered(line, found.segments) < 0.8 ? 1 : 0;
  }
  CHECK(misses <= 10);
}

TEST_CASE("nothing is found where nothing is") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    const HoughFound found = hough_lines(test::noise({200, 200}, 0.02, seed), randomized(seed));
    CHECK(found.segments.empty());
    CHECK(found.peaks.empty());
  }
  const HoughFound blank = hough_lines(EdgeImage({300, 200}), randomized(1));
  CHECK(blank.result.confident);
  CHECK(blank.result.draws == 0);
}

TEST_CASE("drawing both pixels from anywhere finds lines, with more draws") {
  EdgeImage image = test::noise({300, 240}, 0.004, 6);
  test::draw(image, 20, 30, 280, 200);
  test::draw(image, 30, 200, 270, 60);
  HoughOptions options = randomized(1);
  options.min_length = 60;
  options.max_draws = 200'000'000;
  const HoughFound near = hough_lines(image, options);
  options.pair_radius = 0;
  const HoughFound anywhere = hough_lines(image, options);
  for (const HoughFound* found : {&near, &anywhere}) {
    CHECK(covered({20, 30, 280, 200}, found->segments) > 0.9);
    CHECK(covered({30, 200, 270, 60}, found->segments) > 0.9);
  }
}

TEST_CASE("the peak is the fitted line") {
  EdgeImage image({200, 160});
  test::draw(image, 20, 30, 180, 110);  // slope 1/2: normal (-1, 2) / sqrt(5)
  const HoughFound found = hough_lines(image, randomized(2));
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].theta == Approx(std::atan2(2.0, -1.0)).margin(0.002));
  CHECK(found.peaks[0].rho == Approx((30 * 2 - 20) / std::sqrt(5.0)).margin(0.5));
  CHECK(found.peaks[0].votes == 3);
  CHECK(found.segments.at(0).votes == 3);
}
