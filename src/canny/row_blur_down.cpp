// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <utility>

#include "canny/four_pixels.hpp"
#include "canny/row_kernels.hpp"

namespace straightedge::plain {
namespace {

// Rows at one distance from the middle have one tap, so they are added before they are multiplied.
FourPixels pair_sum(const std::uint8_t* const* middle, std::ptrdiff_t distance, std::int32_t x) noexcept {
  return FourPixels::load(middle[-distance] + x) + FourPixels::load(middle[distance] + x);
}

// The row in the middle and a few pairs, written out by the compiler for each number of them.
template <std::ptrdiff_t... K>
void blur_short(const std::uint8_t* const* middle, const std::uint16_t* taps, std::uint16_t* sums,
                std::int32_t width, std::integer_sequence<std::ptrdiff_t, K...>) noexcept {
  const std::uint32_t centre_tap = taps[0];
  const std::uint32_t tap[] = {taps[K + 1]...};
  for (std::int32_t x = 0; x < width; x += 4) {
    const FourPixels centre = FourPixels::load(middle[0] + x) * centre_tap;
    (centre + ... + (pair_sum(middle, K + 1, x) * tap[K])).store(sums + x);
  }
}

// Any number of pairs.
void blur_long(const std::uint8_t* const* middle, const std::uint16_t* taps, std::int32_t margin,
               std::uint16_t* sums, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; x += 4) {
    FourPixels sum = FourPixels::load(middle[0] + x) * taps[0];
    for (std::int32_t k = 1; k <= margin; ++k) sum = sum + pair_sum(middle, k, x) * taps[k];
    sum.store(sums + x);
  }
}

}  // namespace

void blur_down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint16_t* sums, std::int32_t width) noexcept {
  const std::int32_t margin = tap_count / 2;
  const std::uint8_t* const* const middle = rows + margin;
  const std::uint16_t* const half = taps + margin;
  switch (margin) {
    case 1:
      return blur_short(middle, half, sums, width, std::make_integer_sequence<std::ptrdiff_t, 1>());
    case 2:
      return blur_short(middle, half, sums, width, std::make_integer_sequence<std::ptrdiff_t, 2>());
    case 3:
      return blur_short(middle, half, sums, width, std::make_integer_sequence<std::ptrdiff_t, 3>());
    case 4:
      return blur_short(middle, half, sums, width, std::make_integer_sequence<std::ptrdiff_t, 4>());
    default:
      return blur_long(middle, half, margin, sums, width);
  }
}

}  // namespace straightedge::plain
