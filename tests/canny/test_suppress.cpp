// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

struct Ridge {
  GradientImage dx, dy;
  MagnitudeImage magnitude;
  GrayImage classes;

  explicit Ridge(Size size) : dx(size), dy(size), magnitude(size), classes(size, 5, std::uint8_t{9}) {}

  void set(int x, int y, int m, int gradient_x, int gradient_y) {
    magnitude.at(x, y) = m;
    dx.at(x, y) = static_cast<std::int16_t>(gradient_x);
    dy.at(x, y) = static_cast<std::int16_t>(gradient_y);
  }
  Status suppress(int low, int high) {
    return suppress_non_maxima(dx.view(), dy.view(), magnitude.view(), low, high, classes.view());
  }
};

}  // namespace

TEST_CASE("sectors are the nearest of four directions") {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const double angle = degrees * 3.141592653589793 / 180;
    const int dx = static_cast<int>(std::lround(10000 * std::cos(angle)));
    const int dy = static_cast<int>(std::lround(10000 * std::sin(angle)));
    const int nearest = static_cast<int>(std::lround(degrees / 45.0)) % 4;
    const GradientSector expected[] = {GradientSector::horizontal, GradientSector::falling,
                                       GradientSector::vertical, GradientSector::rising};
    CAPTURE(degrees);
    CHECK(gradient_sector(dx, dy) == expected[nearest]);
  }
  CHECK(gradient_sector(-32768, 0) == GradientSector::horizontal);
  CHECK(gradient_sector(0, -32768) == GradientSector::vertical);
  CHECK(gradient_sector(-32768, -32768) == GradientSector::falling);
  CHECK(gradient_sector(INT32_MIN, 1) == GradientSector::horizontal);
}

TEST_CASE("a ridge two pixels wide keeps its left or upper side") {
  Ridge across({4, 1});
  across.set(1, 0, 100, 100, 0);
  across.set(2, 0, 100, 100, 0);
  REQUIRE(across.suppress(10, 50) == Status::ok);
  CHECK(across.classes.at(1, 0) == strong_edge);
  CHECK(across.classes.at(2, 0) == no_edge);

  Ridge down({1, 4});
  down.set(0, 1, 100, 0, 100);
  down.set(0, 2, 100, 0, 100);
  REQUIRE(down.suppress(10, 50) == Status::ok);
  CHECK(down.classes.at(0, 1) == strong_edge);
  CHECK(down.classes.at(0, 2) == no_edge);
}

TEST_CASE("diagonal ties lose on both sides, and each diagonal looks its own way") {
  Ridge falling({3, 3});
  falling.set(1, 1, 100, 70, 70);
  falling.set(2, 0, 200, 0, 0);
  REQUIRE(falling.suppress(10, 50) == Status::ok);
  CHECK(falling.classes.at(1, 1) == strong_edge);
  falling.set(2, 2, 100, 0, 0);
  REQUIRE(falling.suppress(10, 50) == Status::ok);
  CHECK(falling.classes.at(1, 1) == no_edge);

  Ridge rising({3, 3});
  rising.set(1, 1, 100, 70, -70);
  rising.set(0, 0, 200, 0, 0);
  REQUIRE(rising.suppress(10, 50) == Status::ok);
  CHECK(rising.classes.at(1, 1) == strong_edge);
  rising.set(2, 0, 100, 0, 0);
  REQUIRE(rising.suppress(10, 50) == Status::ok);
  CHECK(rising.classes.at(1, 1) == no_edge);
}

TEST_CASE("thresholds are strict") {
  Ridge ridge({5, 1});
  ridge.set(0, 0, 10, 10, 0);
  ridge.set(2, 0, 11, 11, 0);
  ridge.set(4, 0, 51, 51, 0);
  REQUIRE(ridge.suppress(10, 50) == Status::ok);
  CHECK(ridge.classes.at(0, 0) == no_edge);
  CHECK(ridge.classes.at(2, 0) == weak_edge);
  CHECK(ridge.classes.at(4, 0) == strong_edge);
  REQUIRE(ridge.suppress(10, 51) == Status::ok);
  CHECK(ridge.classes.at(4, 0) == weak_edge);
  CHECK(ridge.classes.guards_intact());
}

TEST_CASE("bad input to suppression") {
  Ridge ridge({5, 4});
  CHECK(ridge.suppress(51, 50) == Status::invalid_option);
  CHECK(ridge.classes.at(0, 0) == 9);
  GrayImage other({4, 5});
  const auto run = [&](ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                       ImageView<std::uint8_t> out) {
    return suppress_non_maxima(dx, dy, ridge.magnitude.view(), 1, 2, out);
  };
  CHECK(run(ridge.dx.view(), ridge.dy.view(), other.view()) == Status::size_mismatch);
  CHECK(run({}, ridge.dy.view(), ridge.classes.view()) == Status::invalid_image);
  CHECK(run(ridge.dx.view(), ridge.dy.view(), {}) == Status::invalid_image);
}
