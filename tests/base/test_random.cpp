// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>

#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

TEST_CASE("PCG32 gives the numbers of its authors' demonstration") {
  Pcg32 random(42, 54);
  const std::array<std::uint32_t, 6> published = {0xa15c02b7, 0x7b47f409, 0xba1d3330,
                                                  0x83d2f293, 0xbfa4784b, 0xcbed606e};
  for (const std::uint32_t number : published) CHECK(random.next() == number);
}

TEST_CASE("a seed repeats itself, another stream does not") {
  Pcg32 first(7, 1), again(7, 1), other(7, 2);
  int same = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::uint32_t number = first.next();
    CHECK(number == again.next());
    same += number == other.next() ? 1 : 0;
  }
  CHECK(same < 3);
}

TEST_CASE("bounded draws stay below the bound") {
  Pcg32 random(3);
  CHECK(random.below(0) == 0);
  CHECK(random.below(1) == 0);
  for (const std::uint32_t bound : {2U, 3U, 10U, 1000U, 0x80000001U, 0xffffffffU}) {
    for (int i = 0; i < 1000; ++i) CHECK(random.below(bound) < bound);
  }
}

TEST_CASE("bounded draws favour nobody") {
  // With 3 * 2^30 values for 2^32 numbers, one value in three would come twice as often.
  Pcg32 random(4);
  const int draws = 300000;
  std::array<int, 3> count = {};
  for (int i = 0; i < draws; ++i) ++count[random.below(3U << 30U) % 3];
  double chi_square = 0;
  for (const int n : count) chi_square += (n - draws / 3.0) * (n - draws / 3.0) / (draws / 3.0);
  CAPTURE(count[0], count[1], count[2]);
  CHECK(chi_square < 13.8);  // 2 degrees of freedom, 0.1 %
}

TEST_CASE("small bounds are evenly drawn") {
  Pcg32 random(5);
  std::array<int, 10> count = {};
  const int draws = 100000;
  for (int i = 0; i < draws; ++i) ++count[random.below(10)];
  double chi_square = 0;
  for (const int n : count) chi_square += (n - draws / 10.0) * (n - draws / 10.0) / (draws / 10.0);
  CHECK(chi_square < 27.9);  // 9 degrees of freedom, 0.1 %
}
