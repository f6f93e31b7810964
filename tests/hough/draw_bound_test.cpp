// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"
#include "straightedge/hough_randomized.hpp"

using namespace straightedge;

TEST_CASE("the chance of hitting a line follows equation (1)") {
  HoughOptions options;
  options.pair_radius = 30;
  options.pair_min_distance = 10;
  CHECK(pair_hit_probability({1000, 100, 30}, options) == Approx(20.0 * 20.0 / (2.0 * 1000 * 100)));
  CHECK(pair_hit_probability({1000, 100, 50}, options) ==
        Approx((40.0 * 40.0 - 20.0 * 20.0) / (2.0 * 1000 * 100)));
  options.pair_radius = 0;
  CHECK(pair_hit_probability({1000, 1000, 50}, options) == Approx(40.0 * 40.0 / (2.0 * 1000 * 1000)));
  CHECK(pair_hit_probability({10, 10, 1000}, options) == 1);
}

TEST_CASE("the number of draws leaves the stated chance of a miss") {
  HoughOptions options;
  const Size size{200, 200};
  for (const double confidence : {0.5, 0.9, 0.99, 0.9999}) {
    for (const int votes : {1, 3, 10}) {
      options.confidence = confidence;
      options.pair_threshold = votes;
      const PairDrawing drawing{2000, 100, 30};
      const double draws = static_cast<double>(draws_needed(drawing, size, options));
      const double mean = draws * pair_hit_probability(drawing, options) / pair_vote_spread(size, options);
      // The sum of the first terms of Poisson's distribution: fewer than `votes` hits.
      double term = std::exp(-mean);
      double miss = 0;
      for (int k = 0; k < votes; ++k, term *= mean / k) miss += term;
      INFO(confidence << " " << votes << " mean " << mean);
      CHECK(miss <= 1 - confidence);
      CHECK(mean < 3 * votes + 6 * -std::log(1 - confidence));
    }
  }
}

TEST_CASE("more pixels, shorter lines and more confidence need more draws") {
  const HoughOptions options;
  const Size size{400, 300};
  const auto base = draws_needed({2000, 200, 40}, size, options);
  CHECK(draws_needed({4000, 200, 40}, size, options) > base);
  CHECK(draws_needed({2000, 400, 40}, size, options) > base);
  CHECK(draws_needed({2000, 200, 30}, size, options) > base);
  HoughOptions sure = options;
  sure.confidence = 0.9999;
  CHECK(draws_needed({2000, 200, 40}, size, sure) > base);
}
