// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "straightedge/line_fit.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

constexpr int trials = 4000;
// The mean of `trials` chi-square numbers of 2 degrees of freedom scatters by 2 / sqrt(trials), a share p of
// events by sqrt(p (1 − p) / trials). Four of those: one seed in 16 000 would fail by chance.
const double mean_tolerance = 4 * 2 / std::sqrt(static_cast<double>(trials));
const double share_tolerance = 4 * std::sqrt(0.01 * 0.99 / trials);

struct TrueLine {
  double theta = 0, rho = 0;
};

TrueLine random_line(Pcg32& random) {
  return {support::uniform(random, -pi / 2, pi / 2), support::uniform(random, -40, 40)};
}

/// The fit to points of the stretch [from, to], each with noise of its own along the normal.
LineFit noisy_fit(const TrueLine& line, double from, double to, Pcg32& random) {
  const double nx = std::cos(line.theta), ny = std::sin(line.theta);
  LineMoments moments;
  for (int i = 0; i < 30; ++i) {
    const double sigma = support::uniform(random, 0.2, 0.6);
    const double s = support::uniform(random, from, to);
    const double d = line.rho + sigma * support::normal(random);
    moments.add(d * nx - s * ny, d * ny + s * nx, 1 / (sigma * sigma));
  }
  LineFit fit;
  REQUIRE(fit_line(moments, fit) == Status::ok);
  return fit;
}

/// Normalised squared error of angle and of offset at the centroid; the two are independent there.
double squared_error(const TrueLine& line, const LineFit& fit) {
  const double angle = std::sin(fit.theta - line.theta) * (std::cos(fit.theta - line.theta) < 0 ? -1 : 1);
  const double offset =
      fit.centroid_x * std::cos(line.theta) + fit.centroid_y * std::sin(line.theta) - line.rho;
  return angle * angle / fit.var_theta + offset * offset / fit.var_offset;
}

void check_same(const LineMoments& a, const LineMoments& b, double margin) {
  CHECK(a.weight == Approx(b.weight).epsilon(1e-12));
  CHECK(a.x == Approx(b.x).epsilon(1e-12).margin(margin));
  CHECK(a.y == Approx(b.y).epsilon(1e-12).margin(margin));
  CHECK(a.xx == Approx(b.xx).epsilon(1e-12).margin(margin));
  CHECK(a.xy == Approx(b.xy).epsilon(1e-12).margin(margin));
  CHECK(a.yy == Approx(b.yy).epsilon(1e-12).margin(margin));
  CHECK(a.count == b.count);
}

}  // namespace

TEST_CASE("errors of the fit are as large as its covariance says") {
  constexpr std::uint64_t seed = 20;
  CAPTURE(seed);
  Pcg32 random(seed, 1);
  double sum = 0;
  int outside = 0;
  for (int i = 0; i < trials; ++i) {
    const TrueLine line = random_line(random);
    const double error = squared_error(line, noisy_fit(line, -20, 20, random));
    sum += error;
    outside += error > 9.21 ? 1 : 0;
  }
  CHECK(sum / trials == Approx(2).margin(mean_tolerance));
  CHECK(static_cast<double>(outside) / trials == Approx(0.01).margin(share_tolerance));
}

TEST_CASE("two fits to pieces of one line differ as chi-square says") {
  constexpr std::uint64_t seed = 21;
  CAPTURE(seed);
  Pcg32 random(seed, 2);
  double sum = 0;
  int rejected = 0;
  for (int i = 0; i < trials; ++i) {
    const TrueLine line = random_line(random);
    const LineFit a = noisy_fit(line, -30, -5, random);
    const LineFit b = noisy_fit(line, 3, 40, random);
    const double chi = line_chi_square(a, b);
    sum += chi;
    rejected += chi > 9.21 ? 1 : 0;
  }
  CHECK(sum / trials == Approx(2).margin(mean_tolerance));
  CHECK(static_cast<double>(rejected) / trials == Approx(0.01).margin(share_tolerance));
}

TEST_CASE("two lines two pixels apart do not pass for one") {
  Pcg32 random(22, 3);
  for (int i = 0; i < 200; ++i) {
    const TrueLine line = random_line(random);
    const TrueLine other{line.theta, line.rho + 2};
    CHECK(line_chi_square(noisy_fit(line, -20, 20, random), noisy_fit(other, -20, 20, random)) > 9.21);
  }
}

TEST_CASE("moments of parts add up to the moments of the whole, bit for bit where sums are exact") {
  Pcg32 random(23, 4);
  LineMoments whole, first, second;
  for (int i = 0; i < 300; ++i) {
    const double x = random.below(1000), y = random.below(1000), w = 1 + random.below(4);
    whole.add(x, y, w);
    (i % 3 == 0 ? first : second).add(x, y, w);
  }
  first.add(second);
  CHECK(first.weight == whole.weight);
  CHECK(first.x == whole.x);
  CHECK(first.y == whole.y);
  CHECK(first.xx == whole.xx);
  CHECK(first.xy == whole.xy);
  CHECK(first.yy == whole.yy);
  CHECK(first.count == whole.count);
}

TEST_CASE("moments seen from another origin are those of the moved points, and come back") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 5);
    const double ox = support::uniform(random, -50, 50), oy = support::uniform(random, -50, 50);
    LineMoments here, there;
    for (int i = 0; i < 40; ++i) {
      const double x = support::uniform(random, -30, 30), y = support::uniform(random, -30, 30);
      const double w = support::uniform(random, 0.1, 3);
      here.add(x, y, w);
      there.add(x - ox, y - oy, w);
    }
    check_same(here.seen_from(ox, oy), there, 1e-7);
    check_same(here.seen_from(ox, oy).seen_from(-ox, -oy), here, 1e-7);
  }
}

TEST_CASE("a fit to merged pieces is the fit to all points, from whatever origins") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 6);
    const TrueLine line = random_line(random);
    LineMoments whole, near_first, near_second;
    const double ax = 17.5, ay = -8.25, bx = -3, by = 40;
    for (int i = 0; i < 60; ++i) {
      const double s = support::uniform(random, -25, 25);
      const double d = line.rho + 0.4 * support::normal(random);
      const double x = d * std::cos(line.theta) - s * std::sin(line.theta);
      const double y = d * std::sin(line.theta) + s * std::cos(line.theta);
      whole.add(x, y);
      if (i % 2 == 0) {
        near_first.add(x - ax, y - ay);
      } else {
        near_second.add(x - bx, y - by);
      }
    }
    LineMoments merged = near_first;
    merged.add(near_second.seen_from(ax - bx, ay - by));
    LineFit batch, fused;
    REQUIRE(fit_line(whole, batch) == Status::ok);
    REQUIRE(fit_line(merged, fused) == Status::ok);
    CHECK(std::fabs(std::sin(batch.theta - fused.theta)) < 1e-9);
    CHECK(fused.centroid_x + ax == Approx(batch.centroid_x).margin(1e-9));
    CHECK(fused.centroid_y + ay == Approx(batch.centroid_y).margin(1e-9));
    CHECK(fused.var_theta == Approx(batch.var_theta).epsilon(1e-9));
    CHECK(fused.residual == Approx(batch.residual).epsilon(1e-6));
  }
}

TEST_CASE("a turned picture of the points has a turned line, with the same covariance") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 7);
    const double turn = support::uniform(random, -pi, pi);
    const double c = std::cos(turn), s = std::sin(turn);
    LineMoments straight, turned;
    for (int i = 0; i < 30; ++i) {
      const double x = support::uniform(random, -20, 20), y = 0.3 * x + support::normal(random);
      straight.add(x, y);
      turned.add(c * x - s * y, s * x + c * y);
    }
    LineFit a, b;
    REQUIRE(fit_line(straight, a) == Status::ok);
    REQUIRE(fit_line(turned, b) == Status::ok);
    CHECK(std::fabs(std::sin(b.theta - a.theta - turn)) < 1e-12);
    CHECK(b.var_theta == Approx(a.var_theta).epsilon(1e-9));
    CHECK(b.residual == Approx(a.residual).epsilon(1e-9));
  }
}
