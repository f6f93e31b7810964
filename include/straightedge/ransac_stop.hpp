// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge {

/// When has RANSAC looked long enough?
///
/// Of n readings k lie on the plane. Three different ones drawn at random all lie on it with the probability
///
///   p = k/n · (k−1)/(n−1) · (k−2)/(n−2)                                                             (1)
///
/// exactly: drawing without putting back is hypergeometric, and the usual (k/n)³ promises too much for small
/// n. After N independent draws such a plane was missed each time with the probability (1−p)^N; the search
/// may end when that is at most 1 − confidence.
///
/// M. A. Fischler, R. C. Bolles, "Random Sample Consensus: A Paradigm for Model Fitting with Applications to
/// Image Analysis and Automated Cartography", Communications of the ACM 24(6), 1981,
/// doi:10.1145/358669.358692.

/// Equation (1); 0 for k < 3, 1 for k >= n.
constexpr double triple_probability(std::uint32_t k, std::uint32_t n) noexcept {
  if (k < 3) return 0;
  if (k >= n) return 1;
  const double inside = k, all = n;
  return (inside / all) * ((inside - 1) / (all - 1)) * ((inside - 2) / (all - 2));
}

/// (1−p)^N by squaring.
constexpr double miss_probability(double p, std::uint64_t draws) noexcept {
  double power = 1 - p;
  double product = 1;
  for (std::uint64_t n = draws; n > 0; n >>= 1U) {
    if ((n & 1U) != 0) product *= power;
    power *= power;
  }
  return product;
}

/// The least N with (1−p)^N <= 1 − confidence, but at most `limit`. No logarithm: powers (1−p)^(2^j) are made
/// by squaring and put together from the largest down. p <= 0 or NaN gives `limit`.
constexpr std::uint32_t draws_needed(double p, double confidence, std::uint32_t limit) noexcept {
  if (!(p > 0)) return limit;
  const double miss = 1 - confidence;
  double powers[32] = {1 - p};
  for (int j = 1; j < 32; ++j) powers[j] = powers[j - 1] * powers[j - 1];
  // The greatest N with (1−p)^N > miss, one bit at a time; one more is enough.
  std::uint64_t still_missing = 0;
  double product = 1;
  for (int j = 31; j >= 0; --j) {
    if (!(product * powers[j] > miss)) continue;
    product *= powers[j];
    still_missing += std::uint64_t{1} << static_cast<unsigned>(j);
  }
  return still_missing + 1 < limit ? static_cast<std::uint32_t>(still_missing + 1) : limit;
}

}  // namespace straightedge
