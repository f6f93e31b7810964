// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "ransac/rows.hpp"
#include "ransac/triple.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Columns {
  std::vector<float> x, y, z, w;
  std::uint32_t readings = 0;

  explicit Columns(std::uint32_t n) : readings(n) {
    for (auto* column : {&x, &y, &z, &w}) column->assign(ransac::padded(n), 0.0F);
  }
  ransac::Rows rows() const { return {x.data(), y.data(), z.data(), w.data(), ransac::padded(readings)}; }
};

Columns columns_by_chance(std::uint32_t n, Pcg32& random) {
  Columns c(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (auto* column : {&c.x, &c.y, &c.z, &c.w})
      (*column)[i] = static_cast<float>(random.below(2001)) / 1000.0F - 1.0F;
  return c;
}

}  // namespace

TEST_CASE("The MSAC cost is the sum of truncated squares, and padding costs nothing", "[ransac]") {
  Pcg32 random(7);
  for (std::uint32_t n = 1; n <= 100; ++n) {
    const Columns c = columns_by_chance(n, random);
    const ransac::Coefficients k{0.5F, -1.5F, 1.25F, 0.75F};
    double cost = 0;
    std::uint32_t inliers = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const float e = (k.x * c.x[i] + k.y * c.y[i]) + (k.z * c.z[i] + k.w * c.w[i]);
      const double squared = static_cast<double>(e) * static_cast<double>(e);
      cost += squared < 1 ? squared : 1;
      inliers += e * e < 1 ? 1 : 0;
    }
    CAPTURE(n);
    CHECK(static_cast<double>(ransac::msac_cost(c.rows(), k)) == Approx(cost).epsilon(1e-6));
    CHECK(ransac::count_inliers(c.rows(), n, k) == inliers);
  }
}

TEST_CASE("A residual that is no number costs as much as an outlier", "[ransac]") {
  Columns c(16);
  c.x[3] = std::numeric_limits<float>::quiet_NaN();
  c.x[5] = std::numeric_limits<float>::infinity();
  CHECK(ransac::msac_cost(c.rows(), {1, 0, 0, 0}) == 2);
  CHECK(ransac::count_inliers(c.rows(), 16, {1, 0, 0, 0}) == 14);
}

TEST_CASE("Every triple of different numbers is drawn equally often", "[ransac]") {
  constexpr std::uint32_t n = 5;
  constexpr int draws = 60'000;
  std::vector<int> seen(n * n * n);
  Pcg32 random(11);
  for (int i = 0; i < draws; ++i) {
    const ransac::Triple t = ransac::draw_three(random, n);
    REQUIRE(std::set<std::uint32_t>{t.of[0], t.of[1], t.of[2]}.size() == 3);
    ++seen[(t.of[0] * n + t.of[1]) * n + t.of[2]];
  }
  double chi_square = 0;
  int kinds = 0;
  for (const int count : seen) {
    if (count == 0) continue;
    ++kinds;
    chi_square += (count - draws / 60.0) * (count - draws / 60.0) / (draws / 60.0);
  }
  CHECK(kinds == 60);
  CHECK(chi_square < 99);  // 59 degrees of freedom, one chance in a thousand
}
