// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge {

/// The one source of chance: PCG32 (XSH-RR, 64-bit state, 32-bit output).
///
/// Equal seed and stream give equal numbers on every machine. Streams of one seed are independent
/// of one another, so piece of work i draws from stream i and no order of work matters.
///
/// M. E. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
/// Random Number Generation", Harvey Mudd College HMC-CS-2014-0905, 2014.
class Pcg32 {
 public:
  constexpr explicit Pcg32(std::uint64_t seed, std::uint64_t stream = 0) noexcept
      : increment_((stream << 1U) | 1U) {
    next();
    state_ += seed;
    next();
  }

  constexpr std::uint32_t next() noexcept {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
  }

  /// A number in [0, bound), every one equally likely; 0 when bound is 0. Products that would favour
  /// small numbers are drawn again (D. Lemire, 2019, doi:10.1145/3230636).
  constexpr std::uint32_t below(std::uint32_t bound) noexcept {
    if (bound == 0) return 0;
    std::uint64_t product = std::uint64_t{next()} * bound;
    auto low = static_cast<std::uint32_t>(product);
    if (low < bound) {
      const std::uint32_t limit = (0U - bound) % bound;
      while (low < limit) {
        product = std::uint64_t{next()} * bound;
        low = static_cast<std::uint32_t>(product);
      }
    }
    return static_cast<std::uint32_t>(product >> 32U);
  }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace straightedge
