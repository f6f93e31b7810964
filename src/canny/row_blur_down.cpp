// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <utility>

#include "canny/four_pixels.hpp"
#include "canny/row_kernels.hpp"

namespace straightedge::plain {
namespace {

// Rows at one distance from the middle have one tap, so they are added before they are multiplied.
struct RowPair {
  const std::uint8_t* above;
  const std::uint8_t* below;
  std::uint32_t tap;

  RowPair(const std::uint8_t* const* middle, const std::uint16_t* middle_tap, std::int32_t distance) noexcept
      : above(middle[-distance]), below(middle[distance]), tap(middle_tap[distance]) {}

  void add_to(FourSums& sums, std::int32_t x) const noexcept {
    sums.add(load_four_bytes(above + x), load_four_bytes(below + x), tap);
  }
};

// The row in the middle and the pairs next to it, written out by the compiler for each number of pairs.
template <std::int32_t... K>
void begin_sums(const std::uint8_t* const* middle, const std::uint16_t* tap, std::uint16_t* sums,
                std::int32_t width, std::integer_sequence<std::int32_t, K...>) noexcept {
  const std::uint8_t* const centre = middle[0];
  const std::uint32_t centre_tap = tap[0];
  const RowPair pairs[] = {RowPair(middle, tap, K + 1)...};
  for (std::int32_t x = 0; x < width; x += 4) {
    FourSums four;
    four.add(load_four_bytes(centre + x), centre_tap);
    (pairs[K].add_to(four, x), ...);
    four.store(sums + x);
  }
}

// A pair further out.
void add_pair(const RowPair& pair, std::uint16_t* sums, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; x += 4) {
    FourSums four;
    pair.add_to(four, x);
    four.add_to(sums + x);
  }
}

}  // namespace

void blur_down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint16_t* sums, std::int32_t width) noexcept {
  const std::int32_t margin = tap_count / 2;
  const std::uint8_t* const* const middle = rows + margin;
  const std::uint16_t* const tap = taps + margin;
  switch (margin) {
    case 1: return begin_sums(middle, tap, sums, width, std::make_integer_sequence<std::int32_t, 1>());
    case 2: return begin_sums(middle, tap, sums, width, std::make_integer_sequence<std::int32_t, 2>());
    case 3: return begin_sums(middle, tap, sums, width, std::make_integer_sequence<std::int32_t, 3>());
    default: break;
  }
  begin_sums(middle, tap, sums, width, std::make_integer_sequence<std::int32_t, 4>());
  for (std::int32_t k = 5; k <= margin; ++k) add_pair(RowPair(middle, tap, k), sums, width);
}

}  // namespace straightedge::plain
