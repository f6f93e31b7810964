// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>

#include "straightedge/random.hpp"
#include "straightedge/segment_refit.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

constexpr Size size{121, 121};
constexpr double middle = 60.5;  // of the image plane
constexpr double half_length = 35;

struct Truth {
  double theta = 0;  ///< of the normal towards the light side; rows count downwards
  double rho = 0;    ///< about the picture's centre
};

support::EdgeScene scene_of(const Truth& truth) {
  support::Canvas canvas(size, 240);
  const double nx = std::cos(truth.theta), ny = std::sin(truth.theta);
  const auto at = [&](double across, double along) {
    return support::Point2{middle + across * nx - along * ny, middle + across * ny + along * nx};
  };
  canvas.paint({at(truth.rho, -half_length), at(truth.rho, half_length), at(truth.rho - 20, half_length),
                at(truth.rho - 20, -half_length)},
               20);
  return support::EdgeScene(canvas.picture());
}

/// The true edge's middle part, moved sideways and turned.
HoughSegment rough_of(const Truth& truth, double aside, double turn) {
  const double nx = std::cos(truth.theta), ny = std::sin(truth.theta);
  const double tx = -std::sin(truth.theta + turn), ty = std::cos(truth.theta + turn);
  const auto pixel = [](double v) { return static_cast<std::int32_t>(std::lround(v)); };
  const double x = middle - 0.5 + (truth.rho + aside) * nx, y = middle - 0.5 + (truth.rho + aside) * ny;
  return {pixel(x - 20 * tx), pixel(y - 20 * ty), pixel(x + 20 * tx), pixel(y + 20 * ty)};
}

/// How far the found line is from the true one in the middle of the picture's edge.
double offset_error(const RefinedSegment& found, const Truth& truth) {
  return (found.fit.centroid_x + 0.5 - middle) * std::cos(truth.theta) +
         (found.fit.centroid_y + 0.5 - middle) * std::sin(truth.theta) - truth.rho;
}

/// The same light side, place, extent and pixels, to these tolerances.
void check_same(const RefinedSegment& found, double light_x, double light_y, double x, double y,
                const RefinedSegment& like) {
  CHECK(found.light_x == Approx(light_x).margin(1e-3));
  CHECK(found.light_y == Approx(light_y).margin(1e-3));
  // Centroids slide along the line when a pixel at an end changes sides; across they may not.
  CHECK((found.fit.centroid_x - x) * light_x + (found.fit.centroid_y - y) * light_y ==
        Approx(0).margin(0.02));
  CHECK(found.length() == Approx(like.length()).margin(2));
  CHECK(static_cast<double>(found.pixels) == Approx(like.pixels).margin(4));
}

}  // namespace

TEST_CASE("a known edge is found from a rough segment beside it") {
  double squares = 0, worst = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 41);
    const Truth truth{support::uniform(random, -pi, pi), support::uniform(random, -15, 15)};
    const double aside = support::uniform(random, -1.2, 1.2), turn = support::uniform(random, -2, 2) * degree;
    const support::EdgeScene scene = scene_of(truth);
    RefinedSegment found;
    REQUIRE(refit_segment(scene.mask, scene.field(), rough_of(truth, aside, turn), {}, found) == Status::ok);
    REQUIRE(found.pixels > 40);
    CHECK(found.light_x * std::cos(truth.theta) + found.light_y * std::sin(truth.theta) > 0.9999);
    const double error = offset_error(found, truth);
    CHECK(std::fabs(error) < 0.1);
    CHECK(found.length() == Approx(2 * half_length).margin(6));
    const double angle =
        std::asin(found.light_x * std::sin(truth.theta) - found.light_y * std::cos(truth.theta));
    CHECK(std::fabs(angle) < 0.3 * degree);
    squares += error * error;
    worst = std::fmax(worst, std::fabs(error));
    ++count;
  }
  CAPTURE(worst);
  CHECK(std::sqrt(squares / count) < 0.02);
}

TEST_CASE("a wider corridor finds the edge from two pixels and four degrees off") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 42);
    const Truth truth{support::uniform(random, -pi, pi), support::uniform(random, -15, 15)};
    const double aside = random.below(2) == 0 ? 2 : -2, turn = random.below(2) == 0 ? 4 : -4;
    const support::EdgeScene scene = scene_of(truth);
    RefitOptions options;
    options.corridor = 3;
    options.rounds = 6;
    RefinedSegment found;
    REQUIRE(refit_segment(scene.mask, scene.field(), rough_of(truth, aside, turn * degree), options, found) ==
            Status::ok);
    REQUIRE(found.pixels > 40);
    CHECK(std::fabs(offset_error(found, truth)) < 0.15);
  }
}

TEST_CASE("a turned or mirrored picture has a turned or mirrored segment") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 43);
    const Truth truth{support::uniform(random, -pi, pi), support::uniform(random, -15, 15)};
    const HoughSegment rough = rough_of(truth, 0.8, 0.01);
    const support::EdgeScene straight = scene_of(truth);
    const support::EdgeScene turned = scene_of({truth.theta + pi / 2, truth.rho});
    const support::EdgeScene flipped = scene_of({pi - truth.theta, truth.rho});
    RefinedSegment a, b, c;
    const int last = size.width - 1;
    REQUIRE(refit_segment(straight.mask, straight.field(), rough, {}, a) == Status::ok);
    REQUIRE(refit_segment(turned.mask, turned.field(), {last - rough.y0, rough.x0, last - rough.y1, rough.x1},
                          {}, b) == Status::ok);
    REQUIRE(refit_segment(flipped.mask, flipped.field(),
                          {last - rough.x0, rough.y0, last - rough.x1, rough.y1}, {}, c) == Status::ok);
    REQUIRE(a.pixels > 40);
    check_same(b, -a.light_y, a.light_x, last - a.fit.centroid_y, a.fit.centroid_x, a);
    check_same(c, -a.light_x, a.light_y, last - a.fit.centroid_x, a.fit.centroid_y, a);
  }
}
