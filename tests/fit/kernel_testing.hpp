// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

namespace test {

/// Floats from row to row.
constexpr std::ptrdiff_t stride = 211;

inline float number(straightedge::Pcg32& random, std::uint32_t odd_of_hundred) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float odd[] = {0, -0.0F, -1, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1e30F};
  if (random.below(100) < odd_of_hundred) return odd[random.below(7)];
  return static_cast<float>(support::uniform(random, 0.2, 2));
}

/// Rows of 1/z, some of them hardly broken, some full of what is no reading.
inline std::vector<float> rows_by_chance(straightedge::Pcg32& random, std::int32_t height) {
  const std::uint32_t odd = random.below(3) * 15;
  std::vector<float> rows(static_cast<std::size_t>(height * stride));
  for (float& q : rows) q = number(random, odd);
  return rows;
}

/// Calls check(kernels for depth frames, random, seed) for each set that the machine has and for each seed.
template <class Check>
void for_sets_and_seeds(std::uint64_t seeds, const Check& check) {
  for (const straightedge::KernelSet& set : straightedge::kernel_sets()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(std::string(set.name), seed);
      straightedge::Pcg32 random(seed);
      check(*set.depth, random, seed);
    }
  }
}

}  // namespace test
