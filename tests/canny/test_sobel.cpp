// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

TEST_CASE("a bare step has the response of the kernel") {
  const int expected[] = {4, 48, 640};
  for (const int aperture : {3, 5, 7}) {
    GrayImage gray({20, 20});
    for (int y = 0; y < 20; ++y) {
      for (int x = 10; x < 20; ++x) gray.at(x, y) = 10;
    }
    GradientImage dx({20, 20}, 3), dy({20, 20}, 4);
    REQUIRE(gradient(gray.view(), aperture, Border::replicate, GradientScale::clamp, dx.view(), dy.view()) ==
            Status::ok);
    CHECK(dx.at(9, 10) == 10 * expected[aperture / 2 - 1]);
    CHECK(dx.at(10, 10) == dx.at(9, 10));
    CHECK(dy.at(10, 10) == 0);
    CHECK(dx.guards_intact());
    CHECK(dy.guards_intact());
  }
}

TEST_CASE("side 7 is cut to 16 bits, or divided by 16 with halves to even") {
  GrayImage step({16, 16});
  for (int y = 0; y < 16; ++y) {
    for (int x = 8; x < 16; ++x) step.at(x, y) = 255;
  }
  GradientImage dx({16, 16}), dy({16, 16});
  const auto run = [&](GradientScale scale) {
    return gradient(step.view(), 7, Border::replicate, scale, dx.view(), dy.view());
  };
  REQUIRE(run(GradientScale::clamp) == Status::ok);
  CHECK(dx.at(8, 8) == 32767);
  REQUIRE(run(GradientScale::sixteenth) == Status::ok);
  CHECK(dx.at(8, 8) == 10200);

  // One bright pixel: dx holds level * smooth * difference, among them 8 and 24 sixteenths.
  for (const int level : {1, 2, 6, 7, 9}) {
    GrayImage dot({16, 16});
    dot.at(8, 8) = static_cast<std::uint8_t>(level);
    GradientImage exact({16, 16}), scaled({16, 16});
    REQUIRE(gradient(dot.view(), 7, Border::replicate, GradientScale::clamp, exact.view(), dy.view()) ==
            Status::ok);
    REQUIRE(gradient(dot.view(), 7, Border::replicate, GradientScale::sixteenth, scaled.view(), dy.view()) ==
            Status::ok);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        CHECK(scaled.at(x, y) == round_half_even(exact.at(x, y) / 16.0));
      }
    }
  }
}

TEST_CASE("bad input to Sobel") {
  const GrayImage gray({7, 5});
  GradientImage dx({7, 5}), dy({7, 5}), other({5, 7});
  const auto run = [&](GrayView in, int aperture, Border border, ImageView<std::int16_t> x,
                       ImageView<std::int16_t> y) {
    return gradient(in, aperture, border, GradientScale::clamp, x, y);
  };
  CHECK(run(gray.view(), 3, Border::replicate, dx.view(), dy.view()) == Status::ok);
  CHECK(run(gray.view(), 4, Border::replicate, dx.view(), dy.view()) == Status::invalid_option);
  CHECK(run(gray.view(), 9, Border::replicate, dx.view(), dy.view()) == Status::invalid_option);
  CHECK(run(gray.view(), 3, static_cast<Border>(5), dx.view(), dy.view()) == Status::invalid_option);
  CHECK(run(gray.view(), 3, Border::replicate, other.view(), dy.view()) == Status::size_mismatch);
  CHECK(run(gray.view(), 3, Border::replicate, dx.view(), other.view()) == Status::size_mismatch);
  CHECK(run(GrayView(), 3, Border::replicate, dx.view(), dy.view()) == Status::invalid_image);
  CHECK(run(gray.view(), 3, Border::replicate, {}, dy.view()) == Status::invalid_image);
  CHECK(gradient(gray.view(), 3, Border::replicate, static_cast<GradientScale>(4), dx.view(), dy.view()) ==
        Status::invalid_option);
  std::vector<std::int16_t> rows(9);
  CHECK(sobel(gray.view(), 3, Border::replicate, GradientScale::clamp, {std::span(rows).first(8), rows},
              dx.view(), dy.view()) == Status::workspace_too_small);
}

TEST_CASE("magnitudes, extremes included") {
  GradientImage dx({3, 1}), dy({3, 1});
  MagnitudeImage m({3, 1});
  dx.at(0, 0) = -3, dy.at(0, 0) = 4;
  dx.at(1, 0) = dy.at(1, 0) = -32768;
  dx.at(2, 0) = 12240, dy.at(2, 0) = -12240;
  REQUIRE(gradient_magnitude(dx.view(), dy.view(), GradientNorm::l1, m.view()) == Status::ok);
  CHECK(m.at(0, 0) == 7);
  CHECK(m.at(1, 0) == 65536);
  CHECK(m.at(2, 0) == 24480);
  REQUIRE(gradient_magnitude(dx.view(), dy.view(), GradientNorm::l2, m.view()) == Status::ok);
  CHECK(m.at(0, 0) == 25);
  CHECK(m.at(1, 0) == INT32_MAX);
  CHECK(m.at(2, 0) == 2 * 12240 * 12240);
  CHECK(gradient_magnitude(dx.view(), dy.view(), static_cast<GradientNorm>(3), m.view()) ==
        Status::invalid_option);
  CHECK(gradient_magnitude(dx.view(), {}, GradientNorm::l1, m.view()) == Status::invalid_image);
  MagnitudeImage other({1, 3});
  CHECK(gradient_magnitude(dx.view(), dy.view(), GradientNorm::l1, other.view()) == Status::size_mismatch);
}
