// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <utility>

#include "canny/row_kernels.hpp"
#include "canny/sobel_taps.hpp"

namespace straightedge::plain {
namespace {

// Step 1 of sobel.hpp. The rows have their margins, and so have the sums.
template <int Side, std::size_t... K>
void sum_columns(const std::uint8_t* const* rows, std::int16_t* smoothed, std::int16_t* differences,
                 std::int32_t length, std::index_sequence<K...>) noexcept {
  using Taps = SobelTaps<Side>;
  const std::uint8_t* const row[] = {rows[K]...};
  for (std::int32_t x = 0; x < length; ++x) {
    smoothed[x] = static_cast<std::int16_t>(((Taps::smooth[K] * row[K][x]) + ...));
    differences[x] = static_cast<std::int16_t>(((Taps::difference[K] * row[K][x]) + ...));
  }
}

template <int Side, GradientScale Scale>
void sobel(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
           std::int32_t width) noexcept {
  const std::int32_t length = width + Side - 1;
  std::int16_t* const smoothed = scratch;
  std::int16_t* const differences = scratch + length;
  sum_columns<Side>(rows, smoothed, differences, length, std::make_index_sequence<Side>());
  sobel_filter_row<Side, Scale>(smoothed, SobelTaps<Side>::difference, dx, width);
  sobel_filter_row<Side, Scale>(differences, SobelTaps<Side>::smooth, dy, width);
}

}  // namespace

// Small enough to look at all eight neighbours at once.
void sobel_3(const std::uint8_t* const* rows, std::int16_t* /*scratch*/, std::int16_t* dx, std::int16_t* dy,
             std::int32_t width) noexcept {
  const std::uint8_t* const above = rows[0];
  const std::uint8_t* const here = rows[1];
  const std::uint8_t* const below = rows[2];
  for (std::int32_t x = 0; x < width; ++x) {
    const std::int32_t falling = below[x + 2] - above[x];  // lower right minus upper left
    const std::int32_t rising = above[x + 2] - below[x];   // upper right minus lower left
    dx[x] = static_cast<std::int16_t>(falling + rising + 2 * (here[x + 2] - here[x]));
    dy[x] = static_cast<std::int16_t>(falling - rising + 2 * (below[x + 1] - above[x + 1]));
  }
}

void sobel_5(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
             std::int32_t width) noexcept {
  sobel<5, GradientScale::clamp>(rows, scratch, dx, dy, width);
}

void sobel_7(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
             std::int32_t width) noexcept {
  sobel<7, GradientScale::sixteenth>(rows, scratch, dx, dy, width);
}

}  // namespace straightedge::plain
