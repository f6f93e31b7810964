// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

namespace straightedge {

namespace detail {

/// The square root of a double by whole numbers alone, rounded to nearest as IEEE 754 wants it.
///
///   1. x = m 2^(2e) with 2^52 <= m < 2^54; a subnormal is shifted up first.
///   2. The root of m 2^54 in whole numbers, one bit a turn: it lies in [2^53, 2^54), so its lowest
///      bit is one bit below a double's last. The remainder says whether more follows.
///   3. Round: up when the bit below is set. A root of a double never lies exactly half way between two.
constexpr double square_root_by_digits(double x) noexcept {
  constexpr std::uint64_t fraction_bits = 52;
  constexpr std::uint64_t hidden_one = std::uint64_t{1} << fraction_bits;
  constexpr std::uint64_t infinity = std::uint64_t{0x7FF} << fraction_bits;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t field = bits >> fraction_bits;
  if ((bits << 1U) == 0 || bits == infinity) return x;  // the zeros, too
  if (!(x > 0)) return std::bit_cast<double>(infinity | hidden_one >> 1U);
  // Step 1.
  std::uint64_t m = bits & (hidden_one - 1);
  auto exponent = static_cast<std::int32_t>(field);
  if (exponent == 0) {
    const int zeros = std::countl_zero(m) - 11;
    m <<= static_cast<unsigned>(zeros);
    exponent = 1 - zeros;
  } else {
    m |= hidden_one;
  }
  exponent -= 1023;
  if (exponent % 2 != 0) {
    m <<= 1U;
    exponent -= 1;
  }
  // Step 2. The remainder stays below twice the root, so 64 bits hold it.
  std::uint64_t root = 0, rest = 0;
  for (int turn = 0; turn < 54; ++turn) {
    const std::uint64_t pair = turn < 27 ? (m >> static_cast<unsigned>(52 - 2 * turn)) & 3U : 0;
    rest = rest << 2U | pair;
    const std::uint64_t trial = root << 2U | 1U;
    root <<= 1U;
    if (rest >= trial) {
      rest -= trial;
      root |= 1U;
    }
  }
  // Step 3.
  const std::uint64_t rounded = (root >> 1U) + (root & 1U);
  const auto biased = static_cast<std::uint64_t>(exponent / 2 + 1023);
  return std::bit_cast<double>((biased << fraction_bits) + (rounded - hidden_one));
}

}  // namespace detail

/// The square root, rounded to nearest: the same bits everywhere. Processors without square roots of doubles
/// (Cortex-M3, M4) have it by whole numbers, so that the core needs no C library for it.
constexpr double square_root(double x) noexcept {
#if defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8))
  return detail::square_root_by_digits(x);
#else
  // Clang has no constants of the built-in function.
  return std::is_constant_evaluated() ? detail::square_root_by_digits(x) : __builtin_sqrt(x);
#endif
}

}  // namespace straightedge
