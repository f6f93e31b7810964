// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/straight_part.hpp"

#include <cmath>
#include <memory>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

struct Places {
  std::unique_ptr<StripBatch> batch = std::make_unique<StripBatch>();
  StripRule strip{.px = 50, .py = 20, .nx = 0, .ny = 1, .half_width = 30, .cos_max_angle = 0.5};

  void add(double x, double y) {
    StripBatch& b = *batch;
    const std::int32_t i = b.count++;
    b.x[i] = x;
    b.y[i] = y;
    b.dx[i] = 0;
    b.dy[i] = 100;
    b.weight[i] = 1;
  }
  std::optional<StraightPart> straight_part() {
    plain_picture_row_kernels.find_inside(strip, *batch);
    return find_straight_part(*batch, strip);
  }
};

/// A course that turns by `turn` (a slope) at x = 60, with noise.
Places bent(double turn, double noise, std::uint64_t seed) {
  Pcg32 random(seed);
  Places places;
  for (int x = 0; x < 100; ++x)
    places.add(x, 20 + 0.1 * x + turn * std::fmax(0, x - 60) + support::uniform(random, -noise, noise));
  return places;
}

}  // namespace

TEST_CASE("a straight edge is straight from end to end, with any noise") {
  for (const double noise : {0.0, 0.1, 0.4, 0.8}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const auto part = bent(0, noise, seed).straight_part();
      INFO("noise " << noise << ", seed " << seed);
      REQUIRE(part);
      CHECK(part->first == 0);
      CHECK(part->end == 100);
      CHECK(part->moments.count == 100);
      CHECK(part->fit.residual <= noise + 1e-6);
    }
  }
}

TEST_CASE("a bent edge ends at the bend, and its line is that of the longer side") {
  for (const double turn : {-0.3, -0.1, 0.1, 0.3}) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const auto part = bent(turn, 0.15, seed).straight_part();
      INFO("turn " << turn << ", seed " << seed);
      REQUIRE(part);
      CHECK(part->first == 0);
      CHECK(std::abs(part->end - 60) <= 8);
      CHECK(-part->fit.normal_x / part->fit.normal_y == Approx(0.1).margin(0.01));
    }
  }
}

TEST_CASE("what is outside the strip does not bend an edge") {
  Places places;
  for (int x = 0; x < 100; ++x) places.add(x, 20 + (x % 9 == 0 ? 9 : 0));
  places.strip.half_width = 2;
  const auto part = places.straight_part();
  REQUIRE(part);
  CHECK(part->end == 100);
  CHECK(part->moments.count == 88);
  CHECK(part->fit.residual < 1e-6);
}

TEST_CASE("the staircase of a slanted wall is no bend") {
  for (const int run : {8, 15, 30}) {
    Places places;
    for (int x = 0; x < 120; ++x) places.add(x, 20 + x / run);
    const auto part = places.straight_part();
    INFO("a step every " << run);
    REQUIRE(part);
    CHECK(part->first == 0);
    CHECK(part->end == 120);
  }
}

TEST_CASE("an arc comes to its end in a piece that is straight") {
  Places places;
  for (int x = 0; x < 100; ++x) places.add(x, 20 + 0.002 * (x - 50) * (x - 50));
  const auto part = places.straight_part();
  REQUIRE(part);
  CHECK(part->fit.residual <= 0.25);
  CHECK(part->end - part->first > 25);
}

TEST_CASE("too few places make no line") {
  Places places;
  CHECK_FALSE(places.straight_part());
  places.add(50, 20);
  CHECK_FALSE(places.straight_part());
  places.add(60, 20);
  CHECK(places.straight_part());
}
