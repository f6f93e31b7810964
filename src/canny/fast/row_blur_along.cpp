// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_blur_along.cpp; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
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

}  // namespace

void blur_along(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
                std::uint8_t* blurred, std::int32_t width) noexcept {
  const std::int32_t margin = tap_count / 2, last = tap_count - 1;
  for (std::int32_t x = 0; x < width; x += Lanes16::count) {
    const std::uint16_t* const first = sums + x - margin;
    ProductSums total = ProductSums::all(taken_off + half);
    for (std::int32_t k = 0; k < last; k += 2) {
      total.add(load_less(first + k), taps[k], load_less(first + k + 1), taps[k + 1]);
    }
    const Lanes16 rightmost = load_less(first + last);
    total.add(rightmost, taps[last], rightmost, 0);
    total.store_bytes(blurred + x);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
