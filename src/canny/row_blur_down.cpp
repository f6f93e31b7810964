// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/four_pixels.hpp"
#include "canny/row_kernels.hpp"

namespace straightedge::plain {
namespace {

// The row in the middle and two pairs of rows around it. Rows at one distance have one tap, so they are
// added before they are multiplied.
void begin_sums(const std::uint8_t* const* middle, const std::uint16_t* taps, std::uint16_t* sums,
                std::int32_t width) noexcept {
  const std::uint8_t* const centre = middle[0];
  const std::uint8_t* const above = middle[-1];
  const std::uint8_t* const below = middle[1];
  const std::uint32_t centre_tap = taps[0], tap = taps[1];
  for (std::int32_t x = 0; x < width; x += 4) {
    const FourPixels pair = FourPixels::load(above + x) + FourPixels::load(below + x);
    (FourPixels::load(centre + x) * centre_tap + pair * tap).store(sums + x);
  }
}

// Pairs of rows `distance` from the middle.
void add_pair(const std::uint8_t* const* middle, std::int32_t distance, std::uint32_t tap,
              std::uint16_t* sums, std::int32_t width) noexcept {
  const std::uint8_t* const above = middle[-distance];
  const std::uint8_t* const below = middle[distance];
  for (std::int32_t x = 0; x < width; x += 4) {
    ((FourPixels::load(above + x) + FourPixels::load(below + x)) * tap).add_to(sums + x);
  }
}

// Two pairs at once: half as often the sums are read and written.
void add_two_pairs(const std::uint8_t* const* middle, std::int32_t distance, const std::uint16_t* taps,
                   std::uint16_t* sums, std::int32_t width) noexcept {
  const std::uint8_t* const above = middle[-distance];
  const std::uint8_t* const below = middle[distance];
  const std::uint8_t* const far_above = middle[-distance - 1];
  const std::uint8_t* const far_below = middle[distance + 1];
  const std::uint32_t tap = taps[0], far_tap = taps[1];
  for (std::int32_t x = 0; x < width; x += 4) {
    const FourPixels pair = FourPixels::load(above + x) + FourPixels::load(below + x);
    const FourPixels far_pair = FourPixels::load(far_above + x) + FourPixels::load(far_below + x);
    (pair * tap + far_pair * far_tap).add_to(sums + x);
  }
}

}  // namespace

void blur_down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
               std::uint16_t* sums, std::int32_t width) noexcept {
  const std::int32_t margin = tap_count / 2;
  const std::uint8_t* const* const middle = rows + margin;
  const std::uint16_t* const from_middle = taps + margin;
  begin_sums(middle, from_middle, sums, width);
  std::int32_t distance = 2;
  for (; distance < margin; distance += 2) {
    add_two_pairs(middle, distance, from_middle + distance, sums, width);
  }
  if (distance == margin) add_pair(middle, distance, from_middle[distance], sums, width);
}

}  // namespace straightedge::plain
