// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_blur_down.cpp; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include "canny/fast/lanes.hpp"
#include "canny/fast/row_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

namespace {

// The largest sum, 256 times 255, fits 16 bits. A number of taps that is known beforehand spares the loops
// over them. `__restrict`: sums that are written change neither the taps nor where the rows are.
template <std::int32_t Known>
void blur(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
          std::uint16_t* __restrict sums, std::int32_t width) noexcept {
  const std::int32_t count = Known > 0 ? Known : tap_count, margin = count / 2;
  const auto load = Lanes16::load_bytes;
  for (std::int32_t x = 0; x < width; x += Lanes16::count) {
    Lanes16 sum = load(rows[margin] + x) * Lanes16::all(taps[margin]);
    for (std::int32_t k = 0; k < margin; ++k) {
      sum = sum + (load(rows[k] + x) + load(rows[count - 1 - k] + x)) * Lanes16::all(taps[k]);
    }
    sum.store(sums + x);
  }
}

}  // namespace

void blur_down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint16_t* sums, std::int32_t width) noexcept {
  if (tap_count == 3) return blur<3>(rows, taps, tap_count, sums, width);
  if (tap_count == 5) return blur<5>(rows, taps, tap_count, sums, width);
  if (tap_count == 7) return blur<7>(rows, taps, tap_count, sums, width);
  if (tap_count == 9) return blur<9>(rows, taps, tap_count, sums, width);
  blur<0>(rows, taps, tap_count, sums, width);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
