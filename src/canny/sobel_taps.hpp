// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "straightedge/sobel.hpp"

// What the whole-image operator and the row functions share; the steps are those of sobel.hpp.
namespace straightedge {

template <int Side>
struct SobelTaps;
template <>
struct SobelTaps<3> {
  static constexpr int smooth[] = {1, 2, 1};
  static constexpr int difference[] = {-1, 0, 1};
};
template <>
struct SobelTaps<5> {
  static constexpr int smooth[] = {1, 4, 6, 4, 1};
  static constexpr int difference[] = {-1, -2, 0, 2, 1};
};
template <>
struct SobelTaps<7> {
  static constexpr int smooth[] = {1, 6, 15, 20, 15, 6, 1};
  static constexpr int difference[] = {-1, -4, -5, 0, 5, 4, 1};
};

/// Step 3. Adding 7, and one more where the quotient is odd, before the shift rounds halves to even.
template <GradientScale Scale>
std::int16_t sobel_to_16_bits(std::int32_t value) noexcept {
  if constexpr (Scale == GradientScale::sixteenth) value = (value + 7 + ((value >> 4) & 1)) >> 4;
  return static_cast<std::int16_t>(std::clamp<std::int32_t>(value, INT16_MIN, INT16_MAX));
}

/// Step 2, one pixel. Written out by the compiler for each side, so that pixels can be computed side by side.
template <int Side, std::size_t... K>
std::int32_t sobel_weighted_sum(const std::int16_t* sums, const int (&taps)[Side],
                                std::index_sequence<K...>) noexcept {
  return ((taps[K] * sums[K]) + ...);
}

/// Steps 2 and 3 along a row of column sums.
template <int Side, GradientScale Scale>
void sobel_filter_row(const std::int16_t* sums, const int (&taps)[Side], std::int16_t* out,
                      std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    out[x] = sobel_to_16_bits<Scale>(sobel_weighted_sum(sums + x, taps, std::make_index_sequence<Side>()));
  }
}

}  // namespace straightedge
