// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/end_points.hpp"

#include <limits>

#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

constexpr float right_angle = 1.57079637F;

std::vector<HoughSegment> read(const EdgeImage& image, HoughPeak line, EndPointOptions options = {},
                               GradientView gradients = {}) {
  std::vector<HoughSegment> segments(100);
  const EndPointResult result = end_points(image, gradients, line, options, segments);
  CHECK(result.status == Status::ok);
  segments.resize(result.segments);
  return segments;
}

}  // namespace

TEST_CASE("a line's ends are its first and last pixel") {
  EdgeImage image({100, 60});
  test::draw(image, 10, 20, 70, 20);
  const auto found = read(image, {20, right_angle, 61});
  REQUIRE(found.size() == 1);
  CHECK(found[0] == HoughSegment{10, 20, 70, 20, 61, 61});
}

TEST_CASE("holes up to max_gap are bridged, longer ones split, short pieces dropped") {
  EdgeImage image({200, 60});
  test::draw(image, 10, 20, 59, 20);
  test::draw(image, 70, 20, 119, 20);   // a hole of 10
  test::draw(image, 131, 20, 170, 20);  // a hole of 11
  test::draw(image, 190, 20, 195, 20);  // short
  const auto found = read(image, {20, right_angle, 5});
  REQUIRE(found.size() == 2);
  CHECK(found[0] == HoughSegment{10, 20, 119, 20, 5, 100});
  CHECK(found[1] == HoughSegment{131, 20, 170, 20, 5, 40});
  CHECK(read(image, {20, right_angle, 5}, {.max_gap = 9.5}).size() == 3);
  CHECK(read(image, {20, right_angle, 5}, {.max_gap = 19}).size() == 1);
  CHECK(read(image, {20, right_angle, 5}, {.min_length = 5}).size() == 3);
  CHECK(read(image, {20, right_angle, 5}, {.min_length = 5.01}).size() == 2);
}

TEST_CASE("gaps and lengths are Euclidean on a diagonal") {
  EdgeImage image({100, 100});
  test::draw(image, 0, 0, 30, 30);
  test::draw(image, 38, 38, 60, 60);  // 7 pixels missing: 9.9 long
  const HoughPeak diagonal{0, 2.35619449F, 1};
  CHECK(read(image, diagonal, {.max_gap = 9.8}).size() == 2);
  CHECK(read(image, diagonal, {.max_gap = 10}).size() == 1);
  CHECK(read(image, diagonal, {.min_length = 40, .max_gap = 9.8}).size() == 1);
}

TEST_CASE("the strip has its width, and the end is the pixel nearest to the line") {
  EdgeImage image({100, 60});
  for (int y = 17; y <= 23; ++y) test::draw(image, 10, y, 70, y);
  CHECK(read(image, {20, right_angle, 1}, {.half_width = 0.5}).at(0).pixels == 61);
  CHECK(read(image, {20, right_angle, 1}, {.half_width = 1.5}).at(0).pixels == 3 * 61);
  CHECK(read(image, {20, right_angle, 1}, {.half_width = 50}).at(0).pixels == 7 * 61);
  CHECK(read(image, {20.3F, right_angle, 1}).at(0).y0 == 20);
  CHECK(read(image, {20.6F, right_angle, 1}).at(0).y0 == 21);
}

TEST_CASE("pieces of scattered pixels are dropped") {
  EdgeImage image({100, 60});
  for (int x = 0; x < 100; x += 5) image.at(x, 20) = 255;
  CHECK(read(image, {20, right_angle, 1}).empty());
  CHECK(read(image, {20, right_angle, 1}, {.min_support = 0.1}).size() == 1);
}

TEST_CASE("with gradients only pixels of the line's direction count") {
  EdgeImage image({100, 60});
  test::draw(image, 10, 20, 70, 20);
  const EndPointOptions options{.gradient_window = 0.2};
  const HoughPeak line{20, right_angle, 1};
  CHECK(read(image, line, options, test::ConstantGradient(image.size(), 1.5).view()).size() == 1);
  CHECK(read(image, line, options, test::ConstantGradient(image.size(), -1.5).view()).size() == 1);
  CHECK(read(image, line, options, test::ConstantGradient(image.size(), 1.3).view()).empty());
  Image<std::int16_t> zero(image.size());
  CHECK(read(image, line, options, {zero.view(), zero.view()}).size() == 1);
}

TEST_CASE("theta 0 and theta pi are one line") {
  EdgeImage image({60, 100});
  test::draw(image, 25, 5, 25, 90);
  const auto at_zero = read(image, {25, 0, 1});
  const auto at_pi = read(image, {-25, 3.14159274F, 1});
  REQUIRE(at_zero.size() == 1);
  CHECK(at_zero[0] == HoughSegment{25, 5, 25, 90, 1, 86});
  CHECK(at_pi == at_zero);
}

TEST_CASE("bad lines, options and views") {
  const EdgeImage image({20, 20}, 255);
  std::vector<HoughSegment> segments(4);
  const auto status = [&](HoughPeak line, EndPointOptions options = {}, GradientView gradients = {}) {
    return end_points(image, gradients, line, options, segments).status;
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  CHECK(status({nan, 0, 1}) == Status::invalid_option);
  CHECK(status({0, nan, 1}) == Status::invalid_option);
  CHECK(status({infinity, 0, 1}) == Status::invalid_option);
  CHECK(status({0, infinity, 1}) == Status::invalid_option);
  CHECK(status({5, 0, 1}, {.max_gap = -1}) == Status::invalid_option);
  CHECK(status({5, 0, 1}, {.half_width = 0}) == Status::invalid_option);
  CHECK(status({5, 0, 1}, {.min_support = 1.5}) == Status::invalid_option);
  CHECK(status({5, 0, 1}, {.gradient_window = 0.1}) == Status::invalid_image);
  const test::ConstantGradient other({20, 21}, 0);
  CHECK(status({5, 0, 1}, {.gradient_window = 0.1}, other.view()) == Status::size_mismatch);
  CHECK(end_points({}, {}, {5, 0, 1}, {}, segments).status == Status::invalid_image);
  CHECK(end_points(image, {}, {5, 0, 1}, {.min_length = 1}, {}).status == Status::output_full);
  CHECK(read(image, {1e9F, 1.0F, 1}).empty());
  CHECK(read(image, {-500, 0.5F, 1}).empty());
}
