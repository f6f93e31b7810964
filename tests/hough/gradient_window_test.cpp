// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

/// The angles that one pixel with a gradient along `direction` votes for.
std::vector<bool> voted_angles(double direction, HoughOptions options) {
  EdgeImage image({31, 31});
  image.at(20, 11) = 255;
  const test::ConstantGradient gradient(image.size(), direction);
  std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options));
  HoughLines lines;
  REQUIRE(HoughLines::prepare(lines, image.size(), options, memory) == Status::ok);
  std::vector<HoughPeak> peaks(10);
  REQUIRE(lines.run(image, gradient.view(), peaks, {}).status == Status::ok);
  const auto cells = lines.accumulator();
  std::vector<bool> voted(static_cast<std::size_t>(cells.height));
  for (int n = 0; n < cells.height; ++n) {
    int sum = 0;
    for (int r = 0; r < cells.width; ++r) sum += cells.at(r, n);
    REQUIRE(sum <= 1);
    voted[static_cast<std::size_t>(n)] = sum == 1;
  }
  return voted;
}

/// Between two directions modulo pi.
double between(double a, double b) {
  const double d = std::fmod(std::fabs(a - b), pi);
  return std::min(d, pi - d);
}

}  // namespace

TEST_CASE("a pixel votes for the angles within its window, modulo pi, and no others") {
  for (const HoughMethod method : {HoughMethod::standard, HoughMethod::progressive}) {
    for (const double window : {0.01, 0.2, 1.0}) {
      for (const double step : {pi / 180, pi / 90, 0.013}) {
        for (double direction = -3.1; direction < 3.2; direction += 0.17) {
          HoughOptions options;
          options.method = method;
          options.gradient_window = window;
          options.theta_step = step;
          const auto voted = voted_angles(direction, options);
          INFO(direction << " window " << window << " step " << step);
          for (std::size_t n = 0; n < voted.size(); ++n) {
            const double off = between(static_cast<double>(n) * step, direction);
            if (off < window - 1.6 * step) REQUIRE(voted[n]);
            if (off > window + 1.6 * step) REQUIRE_FALSE(voted[n]);
          }
        }
      }
    }
  }
}

TEST_CASE("the window respects the range of angles") {
  HoughOptions options;
  options.method = HoughMethod::standard;
  options.min_theta = 1;
  options.max_theta = 2;
  options.gradient_window = 0.1;
  const auto voted = voted_angles(1.5, options);
  REQUIRE(voted.size() == 57);
  for (std::size_t n = 0; n < voted.size(); ++n) {
    const double off = std::fabs(1 + static_cast<double>(n) * options.theta_step - 1.5);
    if (off < 0.08) CHECK(voted[n]);
    if (off > 0.12) CHECK_FALSE(voted[n]);
  }
  for (const bool one : voted_angles(0.2, options)) CHECK_FALSE(one);
}

TEST_CASE("a wide window and a null gradient mean all angles") {
  HoughOptions options;
  options.gradient_window = pi / 2;
  for (const bool one : voted_angles(0.4, options)) CHECK(one);

  EdgeImage image({60, 40});
  test::draw(image, 3, 5, 55, 30);
  const Image<std::int16_t> zero(image.size());
  options.gradient_window = 0.1;
  const HoughFound windowed = hough_lines(image, options, {zero.view(), zero.view()});
  CHECK(windowed.segments == hough_lines(image, HoughOptions{}).segments);
}

TEST_CASE("lines against the gradient are not found, lines along it are, by every method") {
  EdgeImage image({120, 90});
  test::draw(image, 10, 40, 110, 40);  // normal pi / 2
  test::draw(image, 60, 5, 60, 85);    // normal 0
  for (const auto method : {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
    HoughOptions options;
    options.method = method;
    options.gradient_window = 0.3;
    const test::ConstantGradient gradient(image.size(), 1.55);
    const HoughFound found = hough_lines(image, options, gradient.view());
    REQUIRE(found.segments.size() == 1);
    CHECK(test::same_ends(found.segments[0], 10, 40, 110, 40, 0));
    options.gradient_window = 0;
    CHECK(hough_lines(image, options, gradient.view()).segments.size() == 2);
  }
}
