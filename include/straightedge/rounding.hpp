// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge {

/// The greatest integer that is not above x. For |x| < 2^62.
constexpr std::int64_t floor_to_integer(double x) noexcept {
  const auto whole = static_cast<std::int64_t>(x);
  return static_cast<double>(whole) > x ? whole - 1 : whole;
}

/// The nearest integer, halves to the even one. For |x| < 2^62. Does not depend on the rounding mode.
constexpr std::int64_t round_half_even(double x) noexcept {
  const std::int64_t below = floor_to_integer(x);
  const double rest = x - static_cast<double>(below);
  if (rest < 0.5) return below;
  if (rest > 0.5) return below + 1;
  return below + (below & 1);
}

}  // namespace straightedge
