// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "base/exponential.hpp"
#include "straightedge/random.hpp"
#include "straightedge/rounding.hpp"
#include "support/catch.hpp"

using namespace straightedge;

TEST_CASE("rounding takes halves to the even number") {
  const double inputs[] = {0, 0.5, 1.5, 2.5, 3.5, -0.5, -1.5, -2.5, 0.49999999999999994, 2.5000000000000004,
                           -7};
  for (const double x : inputs) {
    CAPTURE(x);
    CHECK(static_cast<double>(round_half_even(x)) == std::nearbyint(x));
    CHECK(static_cast<double>(floor_to_integer(x)) == std::floor(x));
  }
}

TEST_CASE("rounding is the C library's on random numbers") {
  Pcg32 random(6);
  for (int i = 0; i < 100000; ++i) {
    const double x = (static_cast<double>(random.next()) - 2147483648.0) / (1U << random.below(31));
    CAPTURE(x);
    REQUIRE(static_cast<double>(round_half_even(x)) == std::nearbyint(x));
    REQUIRE(static_cast<double>(floor_to_integer(x)) == std::floor(x));
  }
}

TEST_CASE("the exponential function is the C library's within its stated error") {
  double worst = 0;
  for (double x = -700; x <= 0; x += 0.0037) {
    worst = std::fmax(worst, std::fabs(exponential(x) / std::exp(x) - 1));
  }
  CHECK(worst < 4e-16);
  CHECK(exponential(0) == 1);
  CHECK(exponential(-800) == 0);
  CHECK(exponential(-1e300) == 0);
}
