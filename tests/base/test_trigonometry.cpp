// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

double random_between(Pcg32& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random.next()) / 4294967295.0);
}

}  // namespace

TEST_CASE("sine and cosine are those of the C library within their stated error") {
  Pcg32 random(1);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = random_between(random, -100, 100);
    const SineCosine both = sine_cosine(x);
    worst = std::fmax(worst, std::fabs(both.sine - std::sin(x)));
    worst = std::fmax(worst, std::fabs(both.cosine - std::cos(x)));
  }
  CHECK(worst < 4e-16);
}

TEST_CASE("sine and cosine at the quarters are exact where the argument is") {
  CHECK(sine(0) == 0);
  CHECK(cosine(0) == 1);
  CHECK(sine(pi / 2) == 1);
  CHECK(cosine(pi) == -1);
  CHECK(std::fabs(sine(pi)) < 2e-16);
  CHECK(sine(-1.25) == -sine(1.25));
  CHECK(cosine(-1.25) == cosine(1.25));
}

TEST_CASE("sine of what is no number is NaN") {
  CHECK(std::isnan(sine(std::numeric_limits<double>::quiet_NaN())));
  CHECK(std::isnan(cosine(std::numeric_limits<double>::infinity())));
}

TEST_CASE("arc tangent is the C library's within its stated error") {
  Pcg32 random(2);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = random_between(random, -10, 10);
    const double y = random_between(random, -10, 10);
    worst = std::fmax(worst, std::fabs(arc_tangent(y, x) - std::atan2(y, x)));
  }
  CHECK(worst < 5e-16);
}

TEST_CASE("arc tangent along the axes") {
  CHECK(arc_tangent(0, 1) == 0);
  CHECK(arc_tangent(1, 0) == pi / 2);
  CHECK(arc_tangent(-1, 0) == -pi / 2);
  CHECK(arc_tangent(0, -1) == pi);
  CHECK(arc_tangent(0, 0) == 0);
}

TEST_CASE("a wrapped angle lies in (-pi, pi] and has the same direction") {
  for (double angle = -20; angle < 20; angle += 0.37) {
    const double wrapped = wrap_angle(angle);
    CAPTURE(angle, wrapped);
    CHECK(wrapped > -pi);
    CHECK(wrapped <= pi);
    CHECK(std::fabs(std::sin(wrapped) - std::sin(angle)) < 1e-14);
    CHECK(std::fabs(std::cos(wrapped) - std::cos(angle)) < 1e-14);
  }
  CHECK(wrap_angle(-pi) == pi);
}
