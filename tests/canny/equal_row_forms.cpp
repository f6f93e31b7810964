// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/row_forms.hpp"
#include "support/catch.hpp"

using namespace row_forms;

namespace {

// Options of every kind; thresholds from those that let everything pass to those that let nothing.
CannyOptions random_options(Pcg32& random, double sigma) {
  CannyOptions options;
  options.sigma = sigma;
  options.aperture = 3 + 2 * static_cast<int>(random.below(3));
  options.norm = random.below(2) == 0 ? GradientNorm::l1 : GradientNorm::l2;
  const double scale = options.aperture == 3 ? 1 : options.aperture == 5 ? 12 : 160;
  options.low = scale * (static_cast<double>(random.below(300)) - 20) / 2;
  options.high = options.low + scale * random.below(400) / 2;
  return options;
}

void check_forms(const GrayImage& gray, const CannyOptions& options, const CannyRowOptions& rows) {
  const Found expected = by_planes(gray, options);
  REQUIRE(expected.result.status == Status::ok);
  CHECK(same(fused(gray, options, rows), expected));
  CHECK(same(by_rows(gray, options, rows), expected));
}

}  // namespace

TEST_CASE("row forms equal Canny: small and odd sizes, every option") {
  const double sigmas[] = {0, 0.3, 0.5, 1, 1.4, 2, 3, 50};
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Pcg32 random(seed, 31);
    const Size size{1 + static_cast<int>(random.below(70)), 1 + static_cast<int>(random.below(40))};
    const double sigma = sigmas[random.below(8)];
    const CannyOptions options = random_options(random, sigma);
    const int gap = static_cast<int>(random.below(9));
    const GrayImage gray = random.below(2) == 0 ? support::random_bytes(size, random, gap)
                                                : support::random_scene(size, random, random.below(40));
    const CannyRowOptions rows{.worklist = 1 + random.below(40)};
    CAPTURE(seed, size.width, size.height, sigma, options.aperture, options.low, options.high, rows.worklist);
    check_forms(gray, options, rows);
  }
}

TEST_CASE("row forms equal Canny: every width and every height") {
  for (int n = 1; n <= 70; ++n) {
    Pcg32 random(static_cast<std::uint64_t>(n), 32);
    for (const double sigma : {0.0, 0.5, 1.4, 3.0}) {
      for (const Size size : {Size{n, 12}, Size{12, n}, Size{n, 1}, Size{1, n}}) {
        CAPTURE(size.width, size.height, sigma);
        check_forms(support::random_bytes(size, random), random_options(random, sigma), {});
      }
    }
  }
}

TEST_CASE("row forms equal Canny: the steepest gradients") {
  for (const int aperture : {3, 5, 7}) {
    for (const GradientNorm norm : {GradientNorm::l1, GradientNorm::l2}) {
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Pcg32 random(seed, 33);
        GrayImage gray({41, 30});
        const int period = 1 + static_cast<int>(random.below(7));
        for (int y = 0; y < 30; ++y) {
          for (int x = 0; x < 41; ++x) {
            const bool square = (x / period + y / period) % 2 == 0;
            gray.at(x, y) = seed % 2 == 0 ? (square ? 255 : 0) : (random.below(2) == 0 ? 255 : 0);
          }
        }
        CAPTURE(seed, aperture);
        check_forms(gray, {.sigma = 0, .aperture = aperture, .norm = norm, .low = 0, .high = 1000}, {});
        check_forms(gray, {.sigma = 0, .aperture = aperture, .norm = norm, .low = -5, .high = 1e300}, {});
      }
    }
  }
}
