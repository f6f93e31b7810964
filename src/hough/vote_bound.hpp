// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/square_root.hpp"

namespace straightedge::hough {

/// ln x for x >= 1: halved until at most 2, then the series of 2 artanh((x - 1) / (x + 1)).
constexpr double natural_logarithm(double x) noexcept {
  double result = 0;
  for (; x > 2; x /= 2) result += 0.6931471805599453;
  const double u = (x - 1) / (x + 1);
  double power = u;
  for (int k = 1; k < 30; k += 2, power *= u * u) result += 2 * power / k;
  return result;
}

/// Chernoff's bound: a cell that gets at least so many votes on the mean has fewer than `threshold` with a
/// chance below 1 − confidence.
inline double mean_votes_needed(double confidence, double threshold) noexcept {
  const double k = natural_logarithm(1 / (1 - confidence));
  const double root = (square_root(2 * k) + square_root(2 * k + 4 * threshold)) / 2;
  return root * root;
}

}  // namespace straightedge::hough
