// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"

using namespace straightedge;

namespace {

LineMap placed(const MapPlacement& placement) {
  LineMap map = small_line_map();
  map.image->placement = placement;
  return map;
}

LineMap metres_of(const LineMap& map) {
  const auto metres = to_metres(map);
  if (!metres) FAIL(metres.failure().sentence);
  return *metres;
}

}  // namespace

TEST_CASE("a map that is only scaled and shifted") {
  const LineMap metres = metres_of(placed({0.5, 10, 20, 0}));
  CHECK(metres.unit == MapUnit::metre);
  // Image centre: 10 + 0.5·320, 20 + 0.5·200.
  const MapLine& wall = metres.lines[0];
  CHECK(wall.theta == pi / 2);
  CHECK(wall.rho == Approx(120 + 0.5 * 101.25));
  CHECK(wall.segments[0].x0 == Approx(170 + 0.5 * 120.5));
  CHECK(wall.segments[0].y0 == Approx(120 + 0.5 * 101.25));
  CHECK(*wall.width == Approx(1.05));
  CHECK(wall.covariance->var_theta == 2.9e-06);
  CHECK(wall.covariance->var_offset == Approx(0.01));
  CHECK(wall.covariance->at_x == Approx(170 + 0.5 * 3.5));
  CHECK(metres.image == placed({0.5, 10, 20, 0}).image);
}

TEST_CASE("where the normal turns round, the free side and the ends turn with it") {
  // The face x = 20 comes to lie at world x = -480: its normal then points to -x.
  const LineMap metres = metres_of(placed({1, -820, 0, 0}));
  const MapLine& face = metres.lines[1];
  CHECK(face.rho == Approx(480));
  CHECK(face.theta == Approx(pi));
  CHECK(face.free == FreeSide::plus);  // was minus: smaller x
  CHECK(face.segments[0].y0 == Approx(280));
  CHECK(face.segments[0].y1 == Approx(140));
  CHECK(metres.lines[0].free == FreeSide::both);
}

TEST_CASE("a quarter turn") {
  const LineMap metres = metres_of(placed({0.1, 0, 0, pi / 2}));
  // World = 0.1·(-(y + 200), x + 320): the face x = 20 lies at Y = 34, theta = pi/2.
  const MapLine& face = metres.lines[1];
  CHECK(face.theta == Approx(pi / 2));
  CHECK(face.rho == Approx(34));
  CHECK(face.segments[0].x0 == Approx(-14));
  CHECK(face.segments[0].x1 == Approx(-28));
}

TEST_CASE("random placements: the rules hold, points go where the picture's pixels go") {
  const std::uint32_t seed = 23;
  RandomLineMaps maps(seed);
  int turned = 0;
  for (int i = 0; i < 2000; ++i) {
    INFO("seed " << seed << ", round " << i);
    const double yaws[] = {0, pi, -pi, pi / 2, -pi / 2, maps.real(-7, 7), maps.real(-900, 900)};
    const MapPlacement placement{maps.real(0.01, 2), maps.real(-1000, 1000), maps.real(-1000, 1000),
                                 yaws[i % 7]};
    const LineMap map = placed(placement);
    const LineMap metres = metres_of(map);
    REQUIRE(check_line_map(metres).empty());
    const double c = std::cos(placement.origin_yaw);
    const double s = std::sin(placement.origin_yaw);
    for (std::size_t k = 0; k < 2; ++k) {
      const MapLine& before = map.lines[k];
      const MapLine& after = metres.lines[k];
      const double along = std::cos(after.theta - before.theta - placement.origin_yaw);
      REQUIRE(std::abs(std::abs(along) - 1) < 1e-9);
      const bool flipped = along < 0;
      turned += flipped;
      REQUIRE(after.free == (flipped ? flip(before.free) : before.free));
      const MapSegment& from = before.segments[0];
      const Point2 to = flipped ? second_end(after.segments[0]) : first_end(after.segments[0]);
      const double u = placement.resolution * (from.x0 + 320);
      const double v = placement.resolution * (from.y0 + 200);
      REQUIRE(to.x == Approx(placement.origin_x + c * u - s * v).margin(1e-9));
      REQUIRE(to.y == Approx(placement.origin_y + s * u + c * v).margin(1e-9));
    }
  }
  CHECK(turned > 500);
}

TEST_CASE("what cannot become metres") {
  LineMap map = small_line_map();
  map.image->placement.reset();
  auto metres = to_metres(map);
  REQUIRE_FALSE(metres);
  CHECK(metres.failure().problem == Problem::bad_content);
  map.image.reset();
  CHECK_FALSE(to_metres(map));

  CHECK_FALSE(to_metres(placed({1e308, 0, 0, 0})));
  CHECK_FALSE(to_metres(placed({1e-300, 1, 1, 0})));
  CHECK_FALSE(to_metres(placed({-1, 0, 0, 0})));

  const LineMap done = metres_of(small_line_map());
  CHECK(metres_of(done) == done);
}
