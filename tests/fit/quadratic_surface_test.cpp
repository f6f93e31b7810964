// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/detail/quadratic_surface.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;
using namespace straightedge::detail;

namespace {

constexpr auto terms = static_cast<Eigen::Index>(QuadraticSums::terms);

struct Sample {
  double x = 0, y = 0, q = 0, weight = 1;
};

std::vector<Sample> random_samples(Pcg32& random, int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double x = support::uniform(random, -1, 1), y = support::uniform(random, -0.8, 0.8);
    const double q = 0.4 + 0.1 * x - 0.2 * y + 0.05 * x * x - 0.02 * x * y + 0.03 * y * y;
    samples.push_back({x, y, q + 0.01 * support::normal(random), support::uniform(random, 1, 16)});
  }
  return samples;
}

QuadraticSums sums_of(const std::vector<Sample>& samples) {
  QuadraticSums sums;
  for (const Sample& s : samples) sums.add(s.x, s.y, s.q, s.weight);
  return sums;
}

struct Oracle {
  Eigen::VectorXd coefficients;
  double squares = 0;
};

/// The ridge as three more samples; QR, where the code under test has normal equations.
Oracle solve(const std::vector<Sample>& samples, double ridge, Eigen::Index columns = terms) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 3, terms);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Sample& s = samples[static_cast<std::size_t>(i)];
    a.row(i) << 1, s.x, s.y, s.x * s.x, s.x * s.y, s.y * s.y;
    a.row(i) *= std::sqrt(s.weight);
    b(i) = s.q * std::sqrt(s.weight);
  }
  for (Eigen::Index k = 0; k < 3; ++k) a(n + k, 3 + k) = std::sqrt(ridge);
  const Eigen::MatrixXd part = a.leftCols(columns);
  Oracle out{part.colPivHouseholderQr().solve(b), 0};
  out.squares = (b - part * out.coefficients).squaredNorm();
  return out;
}

}  // namespace

TEST_CASE("the least squares of a quadratic surface are Eigen's") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Pcg32 random(seed);
    const auto samples = random_samples(random, 8 + static_cast<int>(random.below(60)));
    for (const double ridge : {0.0, 0.7, 50.0}) {
      INFO("seed " << seed << " ridge " << ridge);
      QuadraticFit fit;
      REQUIRE(fit_quadratic(sums_of(samples), ridge, fit));
      const Oracle whole = solve(samples, ridge), flat = solve(samples, ridge, 3);
      for (std::size_t i = 0; i < fit.coefficients.size(); ++i) {
        CHECK(fit.coefficients[i] ==
              Approx(whole.coefficients(static_cast<Eigen::Index>(i))).epsilon(1e-7).margin(1e-9));
      }
      CHECK(fit.squares == Approx(whole.squares).epsilon(1e-6).margin(1e-9));
      CHECK(fit.bend_squares == Approx(flat.squares - whole.squares).epsilon(1e-6).margin(1e-9));
    }
  }
}

TEST_CASE("sums of two sets add up to those of both") {
  Pcg32 random(4);
  auto first = random_samples(random, 20);
  const auto second = random_samples(random, 30);
  QuadraticSums added = sums_of(first);
  added.add(sums_of(second));
  first.insert(first.end(), second.begin(), second.end());
  const QuadraticSums whole = sums_of(first);
  for (std::size_t i = 0; i < whole.moments.size(); ++i) CHECK(added.moments[i] == Approx(whole.moments[i]));
  for (std::size_t i = 0; i < whole.right.size(); ++i) CHECK(added.right[i] == Approx(whole.right[i]));
  CHECK(added.qq == Approx(whole.qq));
  CHECK(added.n == Approx(whole.n));
}

TEST_CASE("a ridge pulls the bend to zero and leaves the best plane") {
  Pcg32 random(9);
  const auto samples = random_samples(random, 50);
  double before = std::numeric_limits<double>::infinity();
  QuadraticFit fit;
  for (const double ridge : {0.0, 1.0, 100.0, 1e4, 1e10}) {
    REQUIRE(fit_quadratic(sums_of(samples), ridge, fit));
    const auto& c = fit.coefficients;
    const double bend = c[3] * c[3] + c[4] * c[4] + c[5] * c[5];
    CHECK(bend < before);
    before = bend;
  }
  const Oracle flat = solve(samples, 0, 3);
  CHECK(before < 1e-14);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(fit.coefficients[i] == Approx(flat.coefficients(static_cast<Eigen::Index>(i))).epsilon(1e-5));
  }
}

TEST_CASE("samples that do not settle the surface give false") {
  QuadraticFit fit;
  CHECK(!fit_quadratic({}, 0, fit));
  CHECK(!fit_quadratic({}, 1, fit));
  QuadraticSums line;
  for (int i = -4; i <= 4; ++i) line.add(0.2 * i, 0.1 * i, 0.5, 1);
  CHECK(!fit_quadratic(line, 0, fit));
  CHECK(!fit_quadratic(line, 1, fit));
  QuadraticSums five;  // three settle a plane, six a bent one
  const std::vector<Sample> corners{{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.5}, {-1, 0.5, 0.5}};
  for (const Sample& s : corners) five.add(s.x, s.y, s.q, 1);
  CHECK(!fit_quadratic(five, 0, fit));
  CHECK(fit_quadratic(five, 1e-3, fit));
  QuadraticSums no_number;
  no_number.add(std::numeric_limits<double>::quiet_NaN(), 0, 1, 1);
  CHECK(!fit_quadratic(no_number, 1, fit));
}

TEST_CASE("the tangent of a bent plane touches it") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Pcg32 random(seed);
    const auto draw = [&](double most) { return support::uniform(random, -most, most); };
    const BentPlane bent{{draw(1e-3), draw(1e-3), 0.5}, draw(1e-6), draw(1e-6), draw(1e-6), 320, 240};
    const double u = 320 + draw(300), v = 240 + draw(200), h = 1e-2;
    const InverseDepthPlane tangent = bent.tangent(u, v);
    INFO("seed " << seed);
    CHECK(tangent.at(u, v) == Approx(bent.at(u, v)).epsilon(1e-13));
    CHECK(tangent.a == Approx((bent.at(u + h, v) - bent.at(u - h, v)) / (2 * h)).epsilon(1e-7).margin(1e-12));
    CHECK(tangent.b == Approx((bent.at(u, v + h) - bent.at(u, v - h)) / (2 * h)).epsilon(1e-7).margin(1e-12));
    const double su = draw(40), sv = draw(40);  // away from there it differs by the quadratic part alone
    const double apart = bent.uu * su * su + bent.uv * su * sv + bent.vv * sv * sv;
    CHECK(bent.at(u + su, v + sv) - tangent.at(u + su, v + sv) == Approx(apart).margin(1e-13));
  }
}

TEST_CASE("the least cost of a common surface is a lower bound, and exact for a single sample") {
  Pcg32 random(20, 1);
  for (int turn = 0; turn < 200; ++turn) {
    INFO("turn " << turn);
    const std::vector<Sample> first = random_samples(random, 40);
    std::vector<Sample> others = random_samples(random, turn % 2 == 0 ? 1 : 30);
    const double off = support::uniform(random, -0.2, 0.2);
    for (Sample& s : others) s.q += off;
    QuadraticSums both = sums_of(first);
    both.add(sums_of(others));
    QuadraticFit one, own{}, common;
    REQUIRE(fit_quadratic(sums_of(first), 0, one));
    REQUIRE(fit_quadratic(both, 0, common));
    if (others.size() > 1) REQUIRE(fit_quadratic(sums_of(others), 0, own));
    const double cost = common.squares - one.squares - own.squares;
    const double least = least_cost(one, sums_of(others));
    CHECK(least <= cost * 1.000001 + 1e-9);
    CHECK(least > 0);
    if (others.size() == 1) CHECK(least == Approx(cost).epsilon(1e-6));
  }
}

TEST_CASE("what was added to sums and taken off again leaves what was there") {
  Pcg32 random(21, 1);
  const std::vector<Sample> first = random_samples(random, 30), second = random_samples(random, 20);
  QuadraticSums sums = sums_of(first);
  sums.add(sums_of(second));
  sums.take_off(sums_of(second));
  const QuadraticSums before = sums_of(first);
  for (std::size_t i = 0; i < before.moments.size(); ++i)
    CHECK(sums.moments[i] == Approx(before.moments[i]).margin(1e-9));
  for (std::size_t i = 0; i < before.right.size(); ++i)
    CHECK(sums.right[i] == Approx(before.right[i]).margin(1e-9));
  CHECK(sums.n == Approx(before.n));
  CHECK(sums.qq == Approx(before.qq));
}
