// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "straightedge/random.hpp"
#include "straightedge/square_root.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

using Limits = std::numeric_limits<double>;

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

bool equal(double x) {
  return bits_of(detail::square_root_by_digits(x)) == bits_of(std::sqrt(x));
}

}  // namespace

TEST_CASE("the root by whole numbers is the processor's on random bits") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t high = random.next() >> 1U;
    const double any = std::bit_cast<double>(high << 32U | random.next());
    if (std::isnan(any)) continue;
    if (!equal(any)) FAIL("the root of " << any << ", draw " << i);  // a text for each would take its time
  }
}

TEST_CASE("the root by whole numbers is exact on squares and right beside them") {
  Pcg32 random(6);
  for (int i = 0; i < 50000; ++i) {
    const double root = random.below(94906265);
    const double square = root * root;
    const bool exact = detail::square_root_by_digits(square) == root;
    const bool beside =
        equal(std::nextafter(square, Limits::infinity())) && equal(std::nextafter(square, 0.0));
    if (!exact || !beside) FAIL("at the square of " << root << ", draw " << i);
  }
}

TEST_CASE("the root by whole numbers takes every subnormal power of two and the ends of the range") {
  for (int power = -1074; power <= 1023; ++power) {
    CAPTURE(power);
    REQUIRE(equal(std::ldexp(1.0, power)));
    REQUIRE(equal(std::ldexp(Limits::max() / 2, power - 1023)));
  }
  CHECK(equal(0.0));
  CHECK(equal(-0.0));
  CHECK(equal(Limits::infinity()));
  CHECK(equal(Limits::max()));
  CHECK(equal(Limits::denorm_min()));
}

TEST_CASE("what has no root is not a number") {
  for (const double x :
       {-1.0, -Limits::denorm_min(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()}) {
    CHECK(std::isnan(detail::square_root_by_digits(x)));
    CHECK(std::isnan(square_root(x)));
  }
}

TEST_CASE("a root can be a constant") {
  static_assert(square_root(9) == 3);
  static_assert(detail::square_root_by_digits(2) == 1.4142135623730951);
  CHECK(square_root(0.25) == 0.5);
}
