// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

MagnitudeImage random_magnitudes(Size size, std::uint32_t bound, Pcg32& random) {
  MagnitudeImage image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) image.at(x, y) = static_cast<std::int32_t>(random.below(bound));
  }
  return image;
}

std::int32_t sorted_median(const MagnitudeImage& image) {
  std::vector<std::int32_t> all;
  for (int y = 0; y < image.size().height; ++y) {
    for (int x = 0; x < image.size().width; ++x) all.push_back(image.at(x, y));
  }
  std::sort(all.begin(), all.end());
  return all[(all.size() - 1) / 2];
}

}  // namespace

TEST_CASE("thresholds in the magnitude's units") {
  const auto l1 = [](double low, double high, int aperture = 3) {
    return to_magnitude({low, high}, GradientNorm::l1, aperture);
  };
  CHECK(l1(20.5, 60.75).low == 20);
  CHECK(l1(20.5, 60.75).high == 60);
  CHECK(l1(-7.5, 0).low == -8);
  CHECK(l1(1000, 1600.5, 7).low == 62);
  CHECK(l1(1000, 1600.5, 7).high == 100);
  CHECK(l1(-infinite, infinite).low == INT32_MIN);
  CHECK(l1(-infinite, infinite).high == INT32_MAX);
  const auto l2 = [](double low, double high, int aperture = 3) {
    return to_magnitude({low, high}, GradientNorm::l2, aperture);
  };
  CHECK(l2(33.3, 99.9).low == 1108);
  CHECK(l2(33.3, 99.9).high == 9980);
  CHECK(l2(-7.5, 0.5).low == -8);
  CHECK(l2(-7.5, 0.5).high == 0);
  CHECK(l2(1e5, infinite).low == 32767 * 32767);
  CHECK(l2(1e5, infinite).high == 32767 * 32767);
  CHECK(l2(1000, 1600, 7).low == 3906);
}

TEST_CASE("thresholds that are none") {
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  CHECK(is_valid(Thresholds{1, 1}));
  CHECK_FALSE(is_valid(Thresholds{1, 0.999}));
  CHECK_FALSE(is_valid(Thresholds{nan_value, 1}));
  CHECK_FALSE(is_valid(Thresholds{1, nan_value}));
}

TEST_CASE("the automatic high threshold is 4.5 medians") {
  Pcg32 random(21);
  for (const std::uint32_t bound : {200U, 3000U, 24480U, 70000U, 0x7fffffffU}) {
    for (const Size size : {Size{1, 1}, Size{2, 1}, Size{37, 23}, Size{64, 64}}) {
      const MagnitudeImage magnitude = random_magnitudes(size, bound, random);
      const double median = sorted_median(magnitude);
      const AutomaticThresholds l1 = automatic_thresholds(magnitude.view(), GradientNorm::l1, 3);
      REQUIRE(l1.status == Status::ok);
      CHECK(l1.median == median);
      CHECK(l1.thresholds.high == std::max(32.0, std::floor(4.5 * median)));
      CHECK(l1.thresholds.low == std::floor(l1.thresholds.high * 2 / 5));
      const AutomaticThresholds l2 = automatic_thresholds(magnitude.view(), GradientNorm::l2, 3);
      CHECK(l2.thresholds.high == std::max(32.0, std::floor(4.5 * std::sqrt(median))));
    }
  }
}

TEST_CASE("without noise the threshold is a step of eight gray levels") {
  const MagnitudeImage flat({30, 20});
  const int steps[] = {32, 384, 5120};
  for (const int aperture : {3, 5, 7}) {
    const AutomaticThresholds chosen = automatic_thresholds(flat.view(), GradientNorm::l1, aperture);
    CHECK(chosen.thresholds.high == steps[aperture / 2 - 1]);
    CHECK(chosen.median == 0);
  }
}

TEST_CASE("noise alone gives next to no edge, a line in noise gives the line") {
  Pcg32 random(22);
  for (const GradientNorm norm : {GradientNorm::l1, GradientNorm::l2}) {
    for (const int amplitude : {3, 12, 40}) {
      GrayImage gray({200, 150});
      for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
          int sum = 0;  // of four even numbers: nearly normal
          for (int i = 0; i < 4; ++i)
            sum += static_cast<int>(random.below(static_cast<std::uint32_t>(amplitude)));
          gray.at(x, y) = static_cast<std::uint8_t>(40 + sum);
        }
      }
      const CannyOptions options{.norm = norm, .thresholds = CannyThresholds::automatic};
      Detector detector(gray.size(), options);
      GrayImage edges(gray.size());
      const CannyResult noise = detector.canny.run(gray.view(), edges.view());
      CAPTURE(amplitude, noise.high);
      CHECK(noise.edges < 200 * 150 / 500);
      for (int y = 0; y < 150; ++y) {
        for (int x = 100; x < 200; ++x) gray.at(x, y) = static_cast<std::uint8_t>(gray.at(x, y) / 4);
      }
      if (amplitude > 12) continue;  // the step must stand out
      const CannyResult line = detector.canny.run(gray.view(), edges.view());
      CHECK(line.edges >= 150);
    }
  }
}

TEST_CASE("bad input to automatic thresholds") {
  const MagnitudeImage flat({3, 2});
  CHECK(automatic_thresholds({}, GradientNorm::l1, 3).status == Status::invalid_image);
  CHECK(automatic_thresholds(flat.view(), GradientNorm::l1, 4).status == Status::invalid_option);
  CHECK(automatic_thresholds(flat.view(), static_cast<GradientNorm>(5), 3).status == Status::invalid_option);
}
