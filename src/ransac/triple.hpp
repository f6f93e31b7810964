// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/random.hpp"

namespace straightedge::ransac {

struct Triple {
  std::uint32_t of[3] = {0, 0, 0};
};

/// Two different numbers below n, each pair equally likely; n >= 2.
inline void draw_two(Pcg32& random, std::uint32_t n, std::uint32_t& a, std::uint32_t& b) noexcept {
  a = random.below(n);
  b = random.below(n - 1);
  b += b >= a ? 1U : 0U;
}

/// Three different numbers below n, each triple equally likely; n >= 3.
inline Triple draw_three(Pcg32& random, std::uint32_t n) noexcept {
  std::uint32_t a = 0, b = 0;
  draw_two(random, n, a, b);
  const std::uint32_t low = a < b ? a : b;
  const std::uint32_t high = a < b ? b : a;
  std::uint32_t c = random.below(n - 2);
  c += c >= low ? 1U : 0U;
  c += c >= high ? 1U : 0U;
  return {{a, b, c}};
}

}  // namespace straightedge::ransac
