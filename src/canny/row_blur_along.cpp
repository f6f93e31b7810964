// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include "canny/row_kernels.hpp"

namespace straightedge::plain {
namespace {

// What 65536 divides, rounded to the nearest.
constexpr std::uint32_t half = 32768;

std::uint8_t rounded(std::uint32_t sum) noexcept {
  return static_cast<std::uint8_t>(sum >> 16U);
}

// Kernels of 2 Margin + 1 taps, all of which stay in registers.
template <std::int32_t Margin>
void blur_short(const std::uint16_t* sums, const std::uint16_t* taps, std::uint8_t* blurred,
                std::int32_t width) noexcept {
  std::uint32_t tap[Margin + 1];
  for (std::int32_t k = 0; k <= Margin; ++k) tap[k] = taps[Margin + k];
  for (std::int32_t x = 0; x < width; ++x) {
    std::uint32_t sum = half + tap[0] * sums[x];
    for (std::int32_t k = 1; k <= Margin; ++k) sum += tap[k] * sums[x - k] + tap[k] * sums[x + k];
    blurred[x] = rounded(sum);
  }
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
    case 3: return blur_short<1>(sums, taps, blurred, width);
    case 5: return blur_short<2>(sums, taps, blurred, width);
    case 7: return blur_short<3>(sums, taps, blurred, width);
    case 9: return blur_short<4>(sums, taps, blurred, width);
    default: return blur_long(sums, taps, tap_count, blurred, width);
  }
}

}  // namespace straightedge::plain
