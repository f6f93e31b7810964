// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

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
    const CannyRowOptions rows{.worklist = 1 + random.below(40),
                               .stripes = 1 + static_cast<std::int32_t>(random.below(6))};
    CAPTURE(seed, size.width, size.height, sigma, options.aperture, options.low, options.high, rows.worklist,
            rows.stripes);
    check_forms(gray, options, rows);
  }
}

TEST_CASE("row forms equal Canny: every width and every height") {
  for (int n = 1; n <= 70; ++n) {
    Pcg32 random(static_cast<std::uint64_t>(n), 32);
    for (const double sigma : {0.0, 0.5, 1.4, 3.0}) {
      for (const Size size : {Size{n, 12}, Size{12, n}, Size{n, 1}, Size{1, n}}) {
        CAPTURE(size.width, size.height, sigma);
        check_forms(support::random_bytes(size, random), random_options(random, sigma),
                    {.stripes = 1 + n % 5});
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

namespace {

// A band that swings up and down through all rows, its border weak but for the end.
GrayImage meander(Size size) {
  GrayImage gray(size);
  const double middle = size.height / 2.0, swing = middle - 5;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double steepness = std::hypot(1, swing / 16 * std::cos(x / 16.0));
      const bool inside = std::abs(y - middle - swing * std::sin(x / 16.0)) < 4 * steepness;
      gray.at(x, y) = static_cast<std::uint8_t>(inside ? (x > size.width * 7 / 8 ? 240 : 100) : 0);
    }
  }
  return gray;
}

Found fused_in_stripes(const GrayImage& gray, const CannyOptions& options, const CannyRowOptions& rows,
                       bool backwards) {
  std::vector<std::byte> workspace(FusedCanny::workspace_bytes(gray.size(), options, rows));
  FusedCanny canny;
  Found found{GrayImage(gray.size(), 3, std::uint8_t{77}), {}};
  found.result.status = FusedCanny::prepare(canny, gray.size(), options, workspace, rows);
  REQUIRE(found.result.status == Status::ok);
  found.result = canny.run_with(gray.view(), found.edges.view(), [=](std::int32_t count, auto work) {
    for (std::int32_t i = 0; i < count; ++i) work(backwards ? count - 1 - i : i);
  });
  return found;
}

}  // namespace

TEST_CASE("an edge that winds through all stripes is found from its end") {
  const GrayImage gray = meander({400, 61});
  const CannyOptions options{.sigma = 1, .low = 20, .high = 400};
  const Found expected = by_planes(gray, options);
  REQUIRE(expected.result.edges > 4 * expected.result.strong);
  for (const std::int32_t stripes : {1, 2, 3, 7, 60, 61, 1000}) {
    for (const std::uint32_t worklist : {1U, 512U}) {
      const CannyRowOptions rows{.worklist = worklist, .stripes = stripes};
      CAPTURE(stripes, worklist);
      CHECK(same(fused_in_stripes(gray, options, rows, false), expected));
      CHECK(same(fused_in_stripes(gray, options, rows, true), expected));
    }
  }
}

TEST_CASE("stripes need a picture of their own for the edges") {
  GrayImage gray = meander({40, 24});
  for (const std::int32_t stripes : {1, 2}) {
    const CannyRowOptions rows{.stripes = stripes};
    std::vector<std::byte> workspace(FusedCanny::workspace_bytes(gray.size(), {}, rows));
    FusedCanny canny;
    REQUIRE(FusedCanny::prepare(canny, gray.size(), {}, workspace, rows) == Status::ok);
    const ImageView<std::uint8_t> whole = gray.view();
    CHECK(canny.run(whole, whole).status == (stripes == 1 ? Status::ok : Status::invalid_image));
  }
  CHECK(FusedCanny::workspace_bytes(gray.size(), {}, {.stripes = 0}) == 0);
  FusedCanny canny;
  CHECK(FusedCanny::prepare(canny, gray.size(), {}, {}, {.stripes = -1}) == Status::invalid_option);
}
