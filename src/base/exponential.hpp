// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "straightedge/rounding.hpp"

namespace straightedge {

/// e^x for x <= 0 from + − × alone, so that every machine gives the same bits; relative error below 4e-16.
/// 0 below −708, where doubles lose digits.
///
/// Steps: (1) x = n ln 2 + r with |r| <= ln 2 / 2, ln 2 in two parts so that little is lost; (2) e^r by its
/// Taylor series, smallest term first; (3) times 2^n, written into the exponent.
constexpr double exponential(double x) noexcept {
  // Step 1. The first part has 32 bits, so its product with n is exact.
  constexpr double ln2_1 = 0.6931471803691238;
  constexpr double ln2_2 = 1.9082149292705877e-10;
  constexpr double per_ln2 = 1.4426950408889634;
  if (!(x >= -708)) return 0;
  const std::int64_t n = round_half_even(x * per_ln2);
  const auto turns = static_cast<double>(n);
  const double r = (x - turns * ln2_1) - turns * ln2_2;
  // Step 2.
  double sum = 1;
  for (int k = 14; k >= 1; --k) sum = 1 + sum * r / k;
  // Step 3.
  const auto power = std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52U);
  return sum * power;
}

}  // namespace straightedge
