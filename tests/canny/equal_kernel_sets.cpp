// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <optional>
#include <string>

#include "canny/row_forms.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/kernels.hpp"
#include "support/catch.hpp"

using namespace row_forms;

namespace {

CannyOptions random_options(Pcg32& random) {
  const double sigmas[] = {0, 0.5, 1, 1.4, 3};
  CannyOptions options;
  options.sigma = sigmas[random.below(5)];
  options.aperture = 3 + 2 * static_cast<int>(random.below(3));
  options.norm = random.below(2) == 0 ? GradientNorm::l1 : GradientNorm::l2;
  const double scale = options.aperture == 3 ? 1 : options.aperture == 5 ? 12 : 160;
  const double lows[] = {-1, 0, scale * random.below(300), 1e300};
  options.low = lows[random.below(4)];
  options.high = options.low + scale * random.below(400);
  return options;
}

/// The environment variable for the time of a test.
class Forced {
 public:
  explicit Forced(const char* name) {
    if (const char* before = std::getenv("STRAIGHTEDGE_KERNELS")) before_ = before;
    setenv("STRAIGHTEDGE_KERNELS", name, 1);
  }
  ~Forced() {
    if (before_) {
      setenv("STRAIGHTEDGE_KERNELS", before_->c_str(), 1);
    } else {
      unsetenv("STRAIGHTEDGE_KERNELS");
    }
  }
  Forced(const Forced&) = delete;
  Forced& operator=(const Forced&) = delete;

 private:
  std::optional<std::string> before_;
};

// A row function that works like the plain one, but finds no gradient in one column.
void wrong_gradient(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx,
                    std::int16_t* dy, std::uint16_t* magnitude, std::int32_t width) noexcept {
  plain_canny_row_kernels.gradient_l1[0](rows, scratch, dx, dy, magnitude, width);
  magnitude[width / 2] = 0;
}

}  // namespace

TEST_CASE("every set of kernels: whole pictures equal Canny") {
  for (const KernelSet& set : kernel_sets()) {
    for (int width = 1; width <= 200; ++width) {
      for (std::uint64_t round = 0; round < 4; ++round) {
        Pcg32 random(static_cast<std::uint64_t>(width), 50 + round);
        const Size size{width, 1 + static_cast<int>(random.below(30))};
        const CannyOptions options = random_options(random);
        const GrayImage gray = round % 2 == 0
                                   ? support::random_bytes(size, random, static_cast<int>(random.below(9)))
                                   : support::random_scene(size, random, random.below(40));
        const CannyRowOptions rows{.worklist = 1 + random.below(30), .kernels = set.canny_rows};
        CAPTURE(std::string(set.name), width, size.height, options.sigma, options.aperture, options.low,
                options.high);
        const Found expected = by_planes(gray, options);
        REQUIRE(expected.result.status == Status::ok);
        CHECK(same(fused(gray, options, rows), expected));
        CHECK(same(by_rows(gray, options, rows), expected));
      }
    }
  }
}

TEST_CASE("the kernels that are asked for are the ones that run") {
  CannyRowKernels wrong = plain_canny_row_kernels;
  wrong.gradient_l1[0] = wrong_gradient;
  Pcg32 random(7, 60);
  const GrayImage gray = support::random_bytes({50, 40}, random);
  const CannyOptions options{.sigma = 0, .low = 300, .high = 600};
  const Found expected = by_planes(gray, options);
  CHECK(same(fused(gray, options, {.kernels = &plain_canny_row_kernels}), expected));
  CHECK_FALSE(same(fused(gray, options, {.kernels = &wrong}), expected));
  CHECK_FALSE(same(by_rows(gray, options, {.kernels = &wrong}), expected));
  const CannyEdges one_call = canny(gray.view(), options, {"wrong", &wrong});
  CHECK(one_call.kernels == "wrong");
  CHECK(one_call.edges != canny(gray.view(), options).edges);
}

TEST_CASE("each set of this machine can be forced by name") {
  CHECK(kernel_sets().front().name == "plain");
  CHECK(kernel_sets().front().canny_rows == &plain_canny_row_kernels);
  CHECK(best_kernels().name == kernel_sets().back().name);
  for (const KernelSet& set : kernel_sets()) {
    const Forced forced(std::string(set.name).c_str());
    const auto chosen = kernels_from_environment();
    REQUIRE(chosen);
    CHECK(chosen->name == set.name);
    CHECK(chosen->canny_rows == set.canny_rows);
  }
  for (const char* name : {"mmx", "", "AVX2", "avx2 "}) {
    const Forced forced(name);
    const auto chosen = kernels_from_environment();
    REQUIRE_FALSE(chosen);
    CHECK(chosen.failure().problem == Problem::bad_option);
    CHECK(chosen.failure().sentence.find("no kernels named \"" + std::string(name) + "\"") !=
          std::string::npos);
  }
}

TEST_CASE("the one call gives what Canny gives, automatic thresholds too") {
  Pcg32 random(3, 61);
  for (const Size size : {Size{1, 1}, Size{15, 9}, Size{16, 9}, Size{131, 40}}) {
    const GrayImage gray = support::random_scene(size, random, 12);
    for (const auto thresholds : {CannyThresholds::given, CannyThresholds::automatic}) {
      CannyOptions options;
      options.thresholds = thresholds;
      const Found expected = by_planes(gray, options);
      const CannyEdges found = canny(gray.view(), options);
      CHECK(found.result.edges == expected.result.edges);
      CHECK(found.result.low == expected.result.low);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) REQUIRE(found.edges.at(x, y) == expected.edges.at(x, y));
      }
    }
  }
}

TEST_CASE("the one call gives the same with any number of threads") {
  Pcg32 random(5, 62);
  ThreadPool pool(3);
  for (const Size size : {Size{1, 1}, Size{9, 31}, Size{64, 64}, Size{131, 333}}) {
    const GrayImage gray = support::random_scene(size, random, 12);
    const CannyEdges expected = canny(gray.view());
    CHECK(canny(gray.view(), {}, best_kernels(), pool).edges == expected.edges);
    for (const unsigned threads : {0U, 2U, 3U, 8U, 1000U}) {
      const CannyEdges found = canny(gray.view(), {}, best_kernels(), threads);
      CAPTURE(size.width, size.height, threads);
      CHECK(found.edges == expected.edges);
      CHECK(found.result.strong == expected.result.strong);
      CHECK(found.result.edges == expected.result.edges);
    }
  }
}

TEST_CASE("the one call: what it gives and what it refuses") {
  GrayImage gray({20, 10});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) gray.at(x, y) = x < 10 ? 20 : 200;
  }
  const CannyEdges found = canny(gray.view());
  REQUIRE(found.result.status == Status::ok);
  CHECK(found.result.edges == 10);
  CHECK(found.edges.size() == Size{20, 10});
  CHECK(found.edges.at(9, 3) == 255);
  CHECK(canny(GrayView()).result.status == Status::invalid_image);
  CHECK(canny(GrayView()).edges.empty());
  CHECK(canny(gray.view(), {.low = 2, .high = 1}).result.status == Status::invalid_option);
}
