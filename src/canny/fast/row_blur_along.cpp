// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_blur_along.cpp; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include <cstring>

#include "canny/fast/lanes.hpp"
#include "canny/fast/row_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// Products are of signed numbers, so 32768 is taken off each sum of a column; the taps add up to 256.
constexpr std::int32_t taken_off = 256 * 32768;
constexpr std::int32_t half = 32768;

Lanes16 load_less(const std::uint16_t* sums) noexcept {
  return Lanes16::load(sums) ^ Lanes16::all(-32768);
}

// The first in the low half.
std::int32_t two(const std::uint16_t* taps) noexcept {
  std::int32_t pair = 0;
  std::memcpy(&pair, taps, sizeof pair);
  return pair;
}

// A vector of sums serves the pixels of even lanes and those to the right of them. A number of taps that is
// known beforehand spares the loops over them. `__restrict`: pixels that are written do not change the taps.
template <std::int32_t Known>
void blur(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
          std::uint8_t* __restrict blurred, std::int32_t width) noexcept {
  const std::int32_t count = Known > 0 ? Known : tap_count, last = count - 1;
  for (std::int32_t x = 0; x < width; x += Lanes16::count) {
    const std::uint16_t* const first = sums + x - count / 2;
    ProductSums total = ProductSums::all(taken_off + half);
    total.add(load_less(first), two(taps), taps[0] << 16);
    for (std::int32_t k = 2; k < last; k += 2) {
      total.add(load_less(first + k), two(taps + k), two(taps + k - 1));
    }
    total.add(load_less(first + last), taps[last], two(taps + last - 1));
    total.store_bytes(blurred + x);
  }
}

}  // namespace

void blur_along(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
                std::uint8_t* blurred, std::int32_t width) noexcept {
  if (tap_count == 3) return blur<3>(sums, taps, tap_count, blurred, width);
  if (tap_count == 5) return blur<5>(sums, taps, tap_count, blurred, width);
  if (tap_count == 7) return blur<7>(sums, taps, tap_count, blurred, width);
  if (tap_count == 9) return blur<9>(sums, taps, tap_count, blurred, width);
  blur<0>(sums, taps, tap_count, blurred, width);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
