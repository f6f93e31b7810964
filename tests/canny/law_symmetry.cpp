// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

GrayImage transposed(const GrayImage& image) {
  GrayImage out({image.size().height, image.size().width});
  for (int y = 0; y < out.size().height; ++y) {
    for (int x = 0; x < out.size().width; ++x) out.at(x, y) = image.at(y, x);
  }
  return out;
}

GrayImage mirrored(const GrayImage& image) {
  GrayImage out(image.size());
  for (int y = 0; y < out.size().height; ++y) {
    for (int x = 0; x < out.size().width; ++x) out.at(x, y) = image.at(out.size().width - 1 - x, y);
  }
  return out;
}

GrayImage inverted(const GrayImage& image) {
  GrayImage out(image.size());
  for (int y = 0; y < out.size().height; ++y) {
    for (int x = 0; x < out.size().width; ++x) out.at(x, y) = static_cast<std::uint8_t>(255 - image.at(x, y));
  }
  return out;
}

// `image` on an even ground, its corner at (left, top).
GrayImage placed(const GrayImage& image, Size ground, int left, int top) {
  GrayImage out(ground, 5, std::uint8_t{90});
  for (int y = 0; y < image.size().height; ++y) {
    for (int x = 0; x < image.size().width; ++x) out.at(left + x, top + y) = image.at(x, y);
  }
  return out;
}

CannyOptions options_of(Pcg32& random, int aperture) {
  const double gain = aperture == 3 ? 1 : aperture == 5 ? 10 : 120;
  return {.sigma = random.below(2) == 0 ? 0 : 0.4 + random.below(30) / 10.0,
          .aperture = aperture,
          .norm = random.below(2) == 0 ? GradientNorm::l1 : GradientNorm::l2,
          .low = gain * random.below(60),
          .high = gain * (60 + random.below(120))};
}

struct Run {
  Detector detector;
  GrayImage edges;

  Run(const GrayImage& gray, const CannyOptions& options)
      : detector(gray.size(), options), edges(gray.size()) {
    REQUIRE(detector.canny.run(gray.view(), edges.view()).status == Status::ok);
  }
  const Canny& canny() const { return detector.canny; }
};

// A pixel whose verdict hangs on which side of a tie it is: horizontal gradient, equal to a neighbour.
bool has_tie(const Canny& canny, int x, int y) {
  if (gradient_sector(canny.gradient_x().at(x, y), canny.gradient_y().at(x, y)) !=
      GradientSector::horizontal) {
    return false;
  }
  const ImageView<const std::int32_t> m = canny.magnitude();
  return (m.contains(x - 1, y) && m.at(x - 1, y) == m.at(x, y)) ||
         (m.contains(x + 1, y) && m.at(x + 1, y) == m.at(x, y));
}

}  // namespace

TEST_CASE("a shifted picture has shifted edges") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Pcg32 random(seed, 4);
    const GrayImage scene = support::random_scene({40, 30}, random, 30);
    const CannyOptions options = options_of(random, 3 + 2 * static_cast<int>(random.below(3)));
    const int dx = static_cast<int>(random.below(20)), dy = static_cast<int>(random.below(20));
    // The ground reaches farther than the blur and the gradient do together.
    const GrayImage here = edges_of(placed(scene, {110, 100}, 20, 20), options);
    const GrayImage there = edges_of(placed(scene, {110, 100}, 20 + dx, 20 + dy), options);
    CAPTURE(seed, dx, dy, options.sigma, options.aperture);
    for (int y = 0; y < 100 - dy; ++y) {
      for (int x = 0; x < 110 - dx; ++x) REQUIRE(there.at(x + dx, y + dy) == here.at(x, y));
    }
  }
}

TEST_CASE("a transposed picture has transposed edges") {
  // Exact at side 3: ties have the same side across and down, and no two values of its gradients lie between
  // the two sector borders' roundings.
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed, 5);
    const Size size{1 + static_cast<int>(random.below(60)), 1 + static_cast<int>(random.below(50))};
    const GrayImage gray = support::random_scene(size, random, random.below(60));
    const CannyOptions options = options_of(random, 3);
    CAPTURE(seed, size.width, size.height, options.sigma, options.low, options.high);
    REQUIRE(edges_of(transposed(gray), options) == transposed(edges_of(gray, options)));
  }
}

TEST_CASE("an inverted picture has the same edges") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed, 6);
    const GrayImage gray = support::random_scene({50, 40}, random, random.below(36));
    CannyOptions options = options_of(random, 3 + 2 * static_cast<int>(random.below(3)));
    options.sigma = 0;  // blurring rounds halves up, in black as in white
    CAPTURE(seed, options.aperture, options.low, options.high);
    REQUIRE(edges_of(inverted(gray), options) == edges_of(gray, options));
  }
}

TEST_CASE("mirroring is exact up to the magnitude, and after it but for ties") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed, 7);
    const Size size{1 + static_cast<int>(random.below(60)), 1 + static_cast<int>(random.below(50))};
    const GrayImage gray = support::random_scene(size, random, random.below(30));
    const CannyOptions options = options_of(random, 3 + 2 * static_cast<int>(random.below(3)));
    const Run run(gray, options);
    const Run mirror(mirrored(gray), options);
    CAPTURE(seed, size.width, size.height, options.sigma, options.aperture);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int other = size.width - 1 - x;
        REQUIRE(run.canny().blurred().at(x, y) == mirror.canny().blurred().at(other, y));
        REQUIRE(run.canny().gradient_x().at(x, y) == -mirror.canny().gradient_x().at(other, y));
        REQUIRE(run.canny().gradient_y().at(x, y) == mirror.canny().gradient_y().at(other, y));
        REQUIRE(run.canny().magnitude().at(x, y) == mirror.canny().magnitude().at(other, y));
        const bool same = run.canny().suppressed().at(x, y) == mirror.canny().suppressed().at(other, y);
        REQUIRE((same || has_tie(run.canny(), x, y)));
      }
    }
  }
}

TEST_CASE("gaps between rows change nothing and are not written") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Pcg32 random(seed, 8);
    const Size size{1 + static_cast<int>(random.below(70)), 1 + static_cast<int>(random.below(40))};
    const CannyOptions options = options_of(random, 3 + 2 * static_cast<int>(random.below(3)));
    Pcg32 pixels(seed), again(seed);
    const GrayImage tight = support::random_bytes(size, pixels, 0);
    const GrayImage loose = support::random_bytes(size, again, 13);
    Detector detector(size, options);
    GrayImage tight_edges(size, 0), loose_edges(size, 17);
    REQUIRE(detector.canny.run(tight.view(), tight_edges.view()).status == Status::ok);
    REQUIRE(detector.canny.run(loose.view(), loose_edges.view()).status == Status::ok);
    CAPTURE(seed, size.width, size.height);
    CHECK(tight_edges == loose_edges);
    CHECK(loose_edges.guards_intact());
    CHECK(loose.guards_intact());
  }
}
