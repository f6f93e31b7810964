// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "straightedge/ransac_stop.hpp"
#include "support/catch.hpp"

using namespace straightedge;

TEST_CASE("The probability of a triple of inliers is that of counting all triples", "[ransac]") {
  for (std::uint32_t n = 3; n <= 12; ++n) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      int inside = 0, all = 0;
      for (std::uint32_t a = 0; a < n; ++a)
        for (std::uint32_t b = 0; b < n; ++b)
          for (std::uint32_t c = 0; c < n; ++c) {
            if (a == b || b == c || a == c) continue;
            ++all;
            inside += a < k && b < k && c < k ? 1 : 0;
          }
      CAPTURE(n, k);
      CHECK(triple_probability(k, n) == Approx(static_cast<double>(inside) / all).margin(1e-12));
    }
  }
}

TEST_CASE("The number of draws is the least that is enough", "[ransac]") {
  for (const double p : {0.9, 0.5, 0.3, 0.1, 0.01, 0.001}) {
    for (const double confidence : {0.5, 0.9, 0.99, 0.999}) {
      std::uint32_t naive = 1;
      while (std::pow(1 - p, naive) > 1 - confidence) ++naive;
      const std::uint32_t needed = draws_needed(p, confidence, 1'000'000);
      CAPTURE(p, confidence);
      // A power that equals the bound but for rounding may fall to either side.
      CHECK(std::abs(static_cast<double>(needed) - naive) <= (p == 0.9 || p == 0.5 ? 1 : 0));
      CHECK(miss_probability(p, needed) <= (1 - confidence) * (1 + 1e-9));
      if (needed > 1) CHECK(miss_probability(p, needed - 1) > (1 - confidence) * (1 - 1e-9));
    }
  }
}

TEST_CASE("Draws at the ends of the range", "[ransac]") {
  CHECK(draws_needed(1, 0.999, 100) == 1);
  CHECK(draws_needed(0, 0.999, 100) == 100);
  CHECK(draws_needed(std::nan(""), 0.999, 100) == 100);
  CHECK(draws_needed(-1, 0.999, 100) == 100);
  CHECK(draws_needed(1e-12, 0.999, 4'000'000'000U) == 4'000'000'000U);
  CHECK(draws_needed(0.5, 0.999, 3) == 3);
  CHECK(triple_probability(2, 100) == 0);
  CHECK(triple_probability(100, 100) == 1);
  CHECK(miss_probability(0.25, 0) == 1);
  CHECK(miss_probability(0.25, 3) == Approx(0.421875));
}

TEST_CASE("The examples of the page on RANSAC", "[ransac]") {
  CHECK(draws_needed(triple_probability(614, 2048), 0.999, 100'000) == 254);
  CHECK(draws_needed(triple_probability(205, 2048), 0.999, 100'000) == 6976);
  CHECK(draws_needed(triple_probability(10, 20), 0.999, 100'000) == 63);
  CHECK(draws_needed(0.125, 0.999, 100'000) == 52);
}
