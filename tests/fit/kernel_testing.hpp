// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

namespace test {

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
