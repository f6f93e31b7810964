// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <utility>

#include "canny/row_kernels.hpp"

namespace straightedge::plain {
namespace {

// What 65536 divides, rounded to the nearest.
constexpr std::uint32_t half = 32768;

std::uint8_t rounded(std::uint32_t sum) noexcept {
  return static_cast<std::uint8_t>(sum >> 16U);
}

// Kernels of 2 Margin + 1 taps, written out by the compiler for each length. Two pixels at once, because
// they share all sums but one on each side; the second may lie beyond the row.
template <std::ptrdiff_t... K>
void blur_short(const std::uint16_t* sums, const std::uint16_t* taps, std::uint8_t* blurred,
                std::int32_t width, std::integer_sequence<std::ptrdiff_t, K...>) noexcept {
  const std::uint16_t* const middle = taps + sizeof...(K);
  const std::uint32_t centre_tap = middle[0];
  const std::uint32_t tap[] = {middle[K + 1]...};
  for (std::int32_t x = 0; x < width; x += 2) {
    const std::uint16_t* const s = sums + x;
    std::uint32_t left = half + centre_tap * s[0], right = half + centre_tap * s[1];
    ((left += tap[K] * (std::uint32_t{s[-K - 1]} + s[K + 1]),
      right += tap[K] * (std::uint32_t{s[-K]} + s[K + 2])),
     ...);
    blurred[x] = rounded(left);
    blurred[x + 1] = rounded(right);
  }
}

template <std::ptrdiff_t Margin>
void blur_short(const std::uint16_t* sums, const std::uint16_t* taps, std::uint8_t* blurred,
                std::int32_t width) noexcept {
  blur_short(sums, taps, blurred, width, std::make_integer_sequence<std::ptrdiff_t, Margin>());
}

// Kernels of any length, a block of pixels at a time.
void blur_long(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint8_t* blurred, std::int32_t width) noexcept {
  constexpr std::int32_t block = 16;
  for (std::int32_t x = 0; x < width; x += block) {
    const std::int32_t length = std::min(block, width - x);
    std::uint32_t total[block];
    std::fill_n(total, block, half);
    const std::uint16_t* shifted = sums + x - tap_count / 2;
    for (std::int32_t k = 0; k < tap_count; ++k, ++shifted) {
      const std::uint32_t tap = taps[k];
      for (std::int32_t i = 0; i < length; ++i) total[i] += tap * shifted[i];
    }
    for (std::int32_t i = 0; i < length; ++i) blurred[x + i] = rounded(total[i]);
  }
}

}  // namespace

void blur_along(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
                std::uint8_t* blurred, std::int32_t width) noexcept {
  switch (tap_count) {
    case 3:
      return blur_short<1>(sums, taps, blurred, width);
    case 5:
      return blur_short<2>(sums, taps, blurred, width);
    case 7:
      return blur_short<3>(sums, taps, blurred, width);
    case 9:
      return blur_short<4>(sums, taps, blurred, width);
    default:
      return blur_long(sums, taps, tap_count, blurred, width);
  }
}

}  // namespace straightedge::plain
