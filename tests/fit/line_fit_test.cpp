// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/line_fit.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

struct WeightedPoint {
  double x, y, w;
};

LineMoments moments_of(const std::vector<WeightedPoint>& points) {
  LineMoments moments;
  for (const WeightedPoint& p : points) moments.add(p.x, p.y, p.w);
  return moments;
}

std::vector<WeightedPoint> cloud(Pcg32& random, int count) {
  const double angle = support::uniform(random, -pi, pi);
  const double far = support::uniform(random, -30, 30);
  std::vector<WeightedPoint> points;
  for (int i = 0; i < count; ++i) {
    const double s = support::uniform(random, -20, 20);
    const double d = far + support::normal(random);
    points.push_back({d * std::cos(angle) - s * std::sin(angle), d * std::sin(angle) + s * std::cos(angle),
                      support::uniform(random, 0.2, 4)});
  }
  return points;
}

/// Weighted scatter along a direction from all pairs of points: no centroid, no moments.
double pair_scatter(const std::vector<WeightedPoint>& points, double dx, double dy) {
  double sum = 0, weight = 0;
  for (const WeightedPoint& p : points) {
    weight += p.w;
    for (const WeightedPoint& q : points) {
      const double d = (p.x - q.x) * dx + (p.y - q.y) * dy;
      sum += p.w * q.w * d * d;
    }
  }
  return sum / (2 * weight);
}

Status fit_of(const std::vector<WeightedPoint>& points) {
  LineFit fit;
  return fit_line(moments_of(points), fit);
}

}  // namespace

TEST_CASE("no direction has less scatter than the fitted normal") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 31);
    const std::vector<WeightedPoint> points = cloud(random, 3 + static_cast<int>(random.below(40)));
    const LineMoments moments = moments_of(points);
    LineFit fit;
    REQUIRE(fit_line(moments, fit) == Status::ok);
    const double across = pair_scatter(points, fit.normal_x, fit.normal_y);
    for (int i = 0; i < 360; ++i) {
      const double angle = i * pi / 360;
      REQUIRE(pair_scatter(points, std::cos(angle), std::sin(angle)) >= across * (1 - 1e-9));
    }
    CHECK(fit.residual == Approx(std::sqrt(across / moments.weight)).epsilon(1e-9));
    CHECK(fit.var_theta == Approx(1 / pair_scatter(points, -fit.normal_y, fit.normal_x)).epsilon(1e-9));
    CHECK(fit.var_offset == Approx(1 / moments.weight).epsilon(1e-12));
  }
}

TEST_CASE("the fitted line passes through the weighted mean of the points") {
  Pcg32 random(7, 32);
  const std::vector<WeightedPoint> points = cloud(random, 25);
  double weight = 0, x = 0, y = 0;
  for (const WeightedPoint& p : points) {
    weight += p.w;
    x += p.w * p.x;
    y += p.w * p.y;
  }
  LineFit fit;
  REQUIRE(fit_line(moments_of(points), fit) == Status::ok);
  CHECK(fit.centroid_x == Approx(x / weight).epsilon(1e-13));
  CHECK(fit.centroid_y == Approx(y / weight).epsilon(1e-13));
  CHECK(fit.distance(x / weight, y / weight) == Approx(0).margin(1e-12));
}

TEST_CASE("points on a line give that line, its normal in the right half of the circle") {
  for (int i = -89; i <= 90; ++i) {
    const double theta = i * degree;
    CAPTURE(i);
    LineMoments moments;
    for (int k = 0; k <= 10; ++k) {
      moments.add(3 * std::cos(theta) - k * std::sin(theta), 3 * std::sin(theta) + k * std::cos(theta));
    }
    LineFit fit;
    REQUIRE(fit_line(moments, fit) == Status::ok);
    // The ends of the half circle are one direction.
    CHECK(std::fabs(std::sin(fit.theta - theta)) < 1e-12);
    CHECK(fit.theta > -pi / 2);
    CHECK(fit.theta <= pi / 2);
    CHECK(fit.normal_x == Approx(std::cos(fit.theta)).margin(1e-14));
    CHECK(fit.normal_y == Approx(std::sin(fit.theta)).margin(1e-14));
    CHECK(fit.residual < 1e-6);
    CHECK(fit.distance(fit.centroid_x + 2 * fit.normal_x, fit.centroid_y + 2 * fit.normal_y) == Approx(2));
  }
}

TEST_CASE("a nearly horizontal line keeps to the half-open range of theta") {
  for (const double slope : {0.0, 1e-300, -1e-300, 1e-30, -1e-30, 1e-17, -1e-17, 1e-12, -1e-12}) {
    CAPTURE(slope);
    LineMoments moments;
    moments.add(0, 0);
    moments.add(1, slope);
    LineFit fit;
    REQUIRE(fit_line(moments, fit) == Status::ok);
    CHECK(fit.theta > -pi / 2);
    CHECK(fit.theta <= pi / 2);
    CHECK(std::fabs(fit.normal_y) == Approx(1));
  }
}

TEST_CASE("what is no line is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(fit_of({}) == Status::invalid_option);
  CHECK(fit_of({{1, 2, 1}}) == Status::invalid_option);
  CHECK(fit_of({{0, 0, 1}, {0, 0, 1}}) == Status::invalid_option);
  CHECK(fit_of({{1, 2, 0}, {3, 4, 0}}) == Status::invalid_option);
  for (const double bad : {nan, infinity, -infinity}) {
    CAPTURE(bad);
    CHECK(fit_of({{bad, 2, 1}, {3, 4, 1}, {5, 5, 1}}) == Status::invalid_option);
    CHECK(fit_of({{1, bad, 1}, {3, 4, 1}, {5, 5, 1}}) == Status::invalid_option);
    CHECK(fit_of({{1, 2, bad}, {3, 4, 1}, {5, 5, 1}}) == Status::invalid_option);
  }
  CHECK(fit_of({{1e200, 2, 1}, {-1e200, 4, 1}}) == Status::invalid_option);
}

TEST_CASE("points in one place are no line, wherever the place is") {
  for (const double x : {0.0, 0.1, 3.7, 1234.567, -0.3}) {
    for (const double y : {0.0, 0.2, -71.3}) {
      for (const int count : {2, 3, 7, 10, 100}) {
        CAPTURE(x, y, count);
        CHECK(fit_of(std::vector<WeightedPoint>(static_cast<std::size_t>(count), {x, y, 0.7})) ==
              Status::invalid_option);
      }
    }
  }
}

TEST_CASE("the floor is added to the variances, by the length for the angle") {
  LineFit fit;
  fit.var_theta = 1e-4;
  fit.var_offset = 0.01;
  const LineFloor floor{.offset = 0.3, .angle_length = 0.5};
  LineFit floored = fit;
  add_floor(floored, 50, floor);
  CHECK(floored.var_offset == Approx(0.01 + 0.09));
  CHECK(floored.var_theta == Approx(1e-4 + 1e-4));
  LineFit dot = fit;
  add_floor(dot, 0, floor);
  CHECK(std::isfinite(dot.var_theta));
  CHECK(dot.var_theta >= floored.var_theta);
}

TEST_CASE("chi-square of two lines is zero for one and the same, and counts standard deviations") {
  LineFit a;
  a.theta = 0.3;
  a.normal_x = std::cos(0.3);
  a.normal_y = std::sin(0.3);
  a.centroid_x = 5;
  a.centroid_y = -2;
  a.var_theta = 1e-4;
  a.var_offset = 0.02;
  CHECK(line_chi_square(a, a) == Approx(0).margin(1e-12));
  LineFit b = a;  // three standard deviations of the difference away
  const double off = 3 * std::sqrt(0.04);
  b.centroid_x += off * a.normal_x;
  b.centroid_y += off * a.normal_y;
  CHECK(line_chi_square(a, b) == Approx(9).epsilon(1e-9));
  LineFit c = a;  // turned by two standard deviations of the difference
  c.theta += 2 * std::sqrt(2e-4);
  c.normal_x = std::cos(c.theta);
  c.normal_y = std::sin(c.theta);
  CHECK(line_chi_square(a, c) == Approx(4).epsilon(1e-9));
}

TEST_CASE("chi-square does not care which way the normals point nor which line comes first") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 33);
    LineFit a, b;
    REQUIRE(fit_line(moments_of(cloud(random, 12)), a) == Status::ok);
    b = a;
    b.centroid_x += support::uniform(random, -9, 9);
    b.centroid_y += support::uniform(random, -9, 9);
    b.theta += support::uniform(random, -0.3, 0.3);
    b.normal_x = std::cos(b.theta);
    b.normal_y = std::sin(b.theta);
    const double chi = line_chi_square(a, b);
    CHECK(chi >= 0);
    LineFit turned = b;
    turned.normal_x = -b.normal_x;
    turned.normal_y = -b.normal_y;
    CHECK(line_chi_square(a, turned) == Approx(chi).epsilon(1e-9));
    CHECK(line_chi_square(turned, a) == Approx(chi).epsilon(1e-9));
    CHECK(line_chi_square(b, a) == Approx(chi).epsilon(1e-9));
  }
}
