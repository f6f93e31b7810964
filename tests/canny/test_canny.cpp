// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>

#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Status prepare_with(const CannyOptions& options, Size size = {20, 10}) {
  std::vector<std::byte> workspace(100000);
  Canny canny;
  const Status status = Canny::prepare(canny, size, options, workspace);
  CHECK((Canny::workspace_bytes(size, options) == 0) == (status != Status::ok));
  return status;
}

// Dark left half, bright right half.
GrayImage step_image(Size size) {
  GrayImage image(size, 7, std::uint8_t{40});
  for (int y = 0; y < size.height; ++y) {
    for (int x = size.width / 2; x < size.width; ++x) image.at(x, y) = 200;
  }
  return image;
}

}  // namespace

TEST_CASE("a step gives one straight edge") {
  const GrayImage gray = step_image({20, 10});
  for (const double sigma : {0.0, 1.4}) {
    Detector detector(gray.size(), {.sigma = sigma});
    REQUIRE(detector.status == Status::ok);
    GrayImage edges(gray.size(), 3);
    const CannyResult result = detector.canny.run(gray.view(), edges.view());
    REQUIRE(result.status == Status::ok);
    CHECK(result.edges == 10);
    CHECK(result.strong == 10);
    CHECK(result.low == 50);
    CHECK(result.high == 150);
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < 20; ++x) CHECK(edges.at(x, y) == (x == 9 ? 255 : 0));
    }
    CHECK(edges.guards_intact());
  }
}

TEST_CASE("what the stages left behind can be read") {
  const GrayImage gray = step_image({20, 10});
  Detector detector(gray.size(), {.sigma = 0, .norm = GradientNorm::l2});
  GrayImage edges(gray.size());
  REQUIRE(detector.canny.run(gray.view(), edges.view()).status == Status::ok);
  CHECK(detector.canny.blurred().at(9, 4) == 40);
  CHECK(detector.canny.gradient_x().at(9, 4) == 640);
  CHECK(detector.canny.gradient_y().at(9, 4) == 0);
  CHECK(detector.canny.magnitude().at(9, 4) == 640 * 640);
  CHECK(detector.canny.suppressed().at(9, 4) == strong_edge);
  CHECK(detector.canny.suppressed().at(10, 4) == no_edge);
}

TEST_CASE("options out of range are refused") {
  CHECK(prepare_with({}) == Status::ok);
  CHECK(prepare_with({.sigma = 50}, {5, 5}) == Status::ok);
  CHECK(prepare_with({.sigma = nan_value}) == Status::invalid_option);
  CHECK(prepare_with({.sigma = -1}) == Status::invalid_option);
  CHECK(prepare_with({.sigma = 50.001}) == Status::invalid_option);
  CHECK(prepare_with({.sigma = infinite}) == Status::invalid_option);
  for (const int aperture : {-1, 0, 1, 2, 4, 6, 8, 9}) {
    CHECK(prepare_with({.aperture = aperture}) == Status::invalid_option);
  }
  CHECK(prepare_with({.norm = static_cast<GradientNorm>(9)}) == Status::invalid_option);
  CHECK(prepare_with({.thresholds = static_cast<CannyThresholds>(9)}) == Status::invalid_option);
}

TEST_CASE("thresholds must be numbers in order") {
  CHECK(prepare_with({.low = 100, .high = 99.9}) == Status::invalid_option);
  CHECK(prepare_with({.low = 100, .high = 100}) == Status::ok);
  CHECK(prepare_with({.low = nan_value, .high = 100}) == Status::invalid_option);
  CHECK(prepare_with({.low = 1, .high = nan_value}) == Status::invalid_option);
  CHECK(prepare_with({.low = -infinite, .high = infinite}) == Status::ok);
  CHECK(prepare_with({.thresholds = CannyThresholds::automatic, .low = nan_value}) == Status::ok);
}

TEST_CASE("huge thresholds are above every edge, negative ones act like 0") {
  Pcg32 random(13);
  const GrayImage gray = support::random_bytes({40, 30}, random);
  for (const GradientNorm norm : {GradientNorm::l1, GradientNorm::l2}) {
    for (const double high : {1e6, 1e300, infinite}) {
      CHECK(edges_of(gray, {.sigma = 0, .norm = norm, .low = 0, .high = high}) == GrayImage(gray.size()));
    }
    const GrayImage zero = edges_of(gray, {.sigma = 0, .norm = norm, .low = 0, .high = 0});
    CHECK_FALSE(zero == GrayImage(gray.size()));
    CHECK(edges_of(gray, {.sigma = 0, .norm = norm, .low = -infinite, .high = -1}) == zero);
  }
}

TEST_CASE("sizes without pixels or with too many are refused") {
  for (const Size size : {Size{0, 10}, Size{10, 0}, Size{-3, 10}, Size{0, 0}}) {
    CHECK(prepare_with({}, size) == Status::invalid_image);
  }
  CHECK(prepare_with({}, {1 << 16, 1 << 16}) == Status::too_large);
  CHECK(prepare_with({}, {INT32_MAX, INT32_MAX}) == Status::too_large);
}

TEST_CASE("a workspace that is one byte short is refused") {
  const Size size{33, 17};
  const std::size_t needed = Canny::workspace_bytes(size, {});
  std::vector<std::byte> workspace(needed);
  Canny canny;
  CHECK(Canny::prepare(canny, size, {}, workspace) == Status::ok);
  CHECK(Canny::prepare(canny, size, {}, std::span(workspace).first(needed - 1)) ==
        Status::workspace_too_small);
  GrayImage gray(size), edges(size, 5, std::uint8_t{9});
  CHECK(canny.run(gray.view(), edges.view()).status == Status::not_prepared);
  CHECK(Canny::prepare(canny, size, {}, {}) == Status::workspace_too_small);
}

TEST_CASE("the workspace may begin anywhere and grows with the pixels") {
  const Size size{33, 17};
  const GrayImage gray = step_image(size);
  const GrayImage expected = edges_of(gray, {});
  const std::size_t needed = Canny::workspace_bytes(size, {});
  for (std::size_t start = 0; start < 64; start += 7) {
    std::vector<std::byte> memory(needed + 64, std::byte{0x5A});
    Canny canny;
    REQUIRE(Canny::prepare(canny, size, {}, std::span(memory).subspan(start, needed)) == Status::ok);
    GrayImage edges(size);
    REQUIRE(canny.run(gray.view(), edges.view()).status == Status::ok);
    CHECK(edges == expected);
    for (std::size_t i = 0; i < start; ++i) REQUIRE(memory[i] == std::byte{0x5A});
    for (std::size_t i = start + needed; i < memory.size(); ++i) REQUIRE(memory[i] == std::byte{0x5A});
  }
  const std::size_t megapixel = Canny::workspace_bytes({1000, 1000}, {});
  const std::size_t four = Canny::workspace_bytes({2000, 2000}, {});
  CHECK(four < 4 * megapixel);
  CHECK(megapixel < 15 * 1000 * 1000);
}

TEST_CASE("memory of a size known to the compiler serves") {
  static constexpr CannyOptions options{.sigma = 1, .aperture = 5};
  static constexpr Size size{64, 48};
  static std::byte workspace[Canny::workspace_bytes(size, options)];
  Canny canny;
  REQUIRE(Canny::prepare(canny, size, options, workspace) == Status::ok);
  const GrayImage gray = step_image(size);
  GrayImage edges(size);
  CHECK(canny.run(gray.view(), edges.view()).edges == 48);
}

TEST_CASE("run without prepare, and views that do not fit") {
  const GrayImage gray = step_image({20, 10});
  GrayImage edges({20, 10}, 5, std::uint8_t{9});
  Canny canny;
  CHECK(canny.run(gray.view(), edges.view()).status == Status::not_prepared);
  CHECK_FALSE(canny.blurred().valid());

  Detector detector({20, 10}, {});
  const GrayImage other({21, 10});
  GrayImage other_edges({20, 11});
  CHECK(detector.canny.run(GrayView(), edges.view()).status == Status::invalid_image);
  CHECK(detector.canny.run(gray.view(), ImageView<std::uint8_t>()).status == Status::invalid_image);
  CHECK(detector.canny.run(other.view(), edges.view()).status == Status::size_mismatch);
  CHECK(detector.canny.run(gray.view(), other_edges.view()).status == Status::size_mismatch);
  GrayView overlapping = gray.view();
  overlapping.stride = 19;
  CHECK(detector.canny.run(overlapping, edges.view()).status == Status::invalid_image);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) REQUIRE(edges.at(x, y) == 9);
  }
}

TEST_CASE("edges may be written over the picture, and runs do not remember") {
  Pcg32 random(11);
  const GrayImage first = support::random_scene({50, 40}, random);
  const GrayImage second = support::random_scene({50, 40}, random);
  Detector detector({50, 40}, {.sigma = 1});
  GrayImage in_place = first;
  REQUIRE(detector.canny.run(in_place.view(), in_place.view()).status == Status::ok);
  CHECK(in_place == edges_of(first, {.sigma = 1}));
  GrayImage edges({50, 40});
  REQUIRE(detector.canny.run(second.view(), edges.view()).status == Status::ok);
  CHECK(edges == edges_of(second, {.sigma = 1}));
}

TEST_CASE("even pictures of any size have no edge") {
  for (const Size size : {Size{1, 1}, Size{1, 50}, Size{50, 1}, Size{2, 2}, Size{31, 17}}) {
    for (const int level : {0, 1, 255}) {
      for (const int aperture : {3, 5, 7}) {
        const GrayImage gray(size, 2, static_cast<std::uint8_t>(level));
        for (const CannyThresholds chosen : {CannyThresholds::given, CannyThresholds::automatic}) {
          Detector detector(size, {.aperture = aperture, .thresholds = chosen, .low = -1, .high = 0});
          GrayImage edges(size, 2, std::uint8_t{3});
          const CannyResult result = detector.canny.run(gray.view(), edges.view());
          REQUIRE(result.status == Status::ok);
          CHECK(result.edges == 0);
          CHECK(edges == GrayImage(size));
        }
      }
    }
  }
}

TEST_CASE("automatic thresholds are reported and are what given ones would do") {
  Pcg32 random(12);
  for (const int aperture : {3, 5, 7}) {
    for (const GradientNorm norm : {GradientNorm::l1, GradientNorm::l2}) {
      const GrayImage gray = support::random_scene({80, 60}, random, 20);
      CannyOptions options{
          .sigma = 0, .aperture = aperture, .norm = norm, .thresholds = CannyThresholds::automatic};
      Detector detector(gray.size(), options);
      GrayImage edges(gray.size());
      const CannyResult result = detector.canny.run(gray.view(), edges.view());
      REQUIRE(result.status == Status::ok);
      CHECK(result.low < result.high);
      options.thresholds = CannyThresholds::given;
      options.low = result.low;
      options.high = result.high;
      CHECK(edges == edges_of(gray, options));
    }
  }
}
