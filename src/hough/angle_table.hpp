// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// The standard method's angles: each is the float before it plus the float step.
void fill_angles_by_adding(HoughJob& job) noexcept;

/// The progressive method's angles: n times the step, in double.
void fill_angles_by_multiplying(HoughJob& job) noexcept;

/// 1.5 * 2^23, and its bits.
inline constexpr float rounding_float = 12582912.0F;
inline constexpr std::uint32_t rounding_bits = 0x4B400000;

/// Nearest integer, halves to even, for |x| < 2^22: adding 1.5 * 2^23 puts the integer into the
/// float's low bits. Distances are fewer than 2^22, and so |x| is below 2^21 and a bit.
inline std::int32_t round_even(float x) noexcept {
  return static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(x + rounding_float) - rounding_bits);
}

/// The distance cell of (x, y) at angle n, before the middle is added.
///
/// With w + h = S, |x cos + y sin| <= S - 2, while there are round((2 S + 1) / rho_step) distances. So
/// middle plus this lies in [-1, distances]: `hough_guard` cells at each end suffice.
inline std::int32_t distance_cell(const HoughMemory& memory, std::size_t n, float x, float y) noexcept {
  return round_even(x * memory.cosines[n] + y * memory.sines[n]);
}

}  // namespace straightedge::hough
