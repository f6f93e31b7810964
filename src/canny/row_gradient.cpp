// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <utility>

#include "canny/gradient_norm.hpp"
#include "canny/row_kernels.hpp"
#include "canny/sobel_taps.hpp"

namespace straightedge::plain {
namespace {

struct L1 {
  using Number = std::uint16_t;
  static Number of(std::int32_t dx, std::int32_t dy) noexcept { return static_cast<Number>(l1_norm(dx, dy)); }
};

// Without the stage's cut at 31 bits: gradients of a Sobel operator stay far below.
struct L2 {
  using Number = std::uint32_t;
  static Number of(std::int32_t dx, std::int32_t dy) noexcept {
    return static_cast<Number>(dx * dx) + static_cast<Number>(dy * dy);
  }
};

// Side 3 is small enough to look at all eight neighbours at once. Rows do not overlap, and with so many of
// them a compiler must be told so before it computes pixels side by side.
template <class Norm>
void gradient_of_3(const std::uint8_t* const* rows, std::int16_t* __restrict dx, std::int16_t* __restrict dy,
                   typename Norm::Number* __restrict magnitude, std::int32_t width) noexcept {
  const std::uint8_t* const above = rows[0];
  const std::uint8_t* const here = rows[1];
  const std::uint8_t* const below = rows[2];
  for (std::int32_t x = 0; x < width; ++x) {
    const std::int32_t falling = below[x + 1] - above[x - 1];  // lower right minus upper left
    const std::int32_t rising = above[x + 1] - below[x - 1];   // upper right minus lower left
    const std::int32_t across = falling + rising + 2 * (here[x + 1] - here[x - 1]);
    const std::int32_t down = falling - rising + 2 * (below[x] - above[x]);
    dx[x] = static_cast<std::int16_t>(across);
    dy[x] = static_cast<std::int16_t>(down);
    magnitude[x] = Norm::of(across, down);
  }
}

// Step 1 of sobel.hpp. The rows have their margins, and so have the sums.
template <int Side, std::size_t... K>
void sum_columns(const std::uint8_t* const* rows, std::int16_t* __restrict smoothed,
                 std::int16_t* __restrict differences, std::int32_t length,
                 std::index_sequence<K...>) noexcept {
  using Taps = SobelTaps<Side>;
  const std::uint8_t* const row[] = {(rows[K] - Side / 2)...};
  for (std::int32_t x = 0; x < length; ++x) {
    smoothed[x] = static_cast<std::int16_t>(((Taps::smooth[K] * row[K][x]) + ...));
    differences[x] = static_cast<std::int16_t>(((Taps::difference[K] * row[K][x]) + ...));
  }
}

template <int Side, class Norm>
void gradient(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
              typename Norm::Number* magnitude, std::int32_t width) noexcept {
  if constexpr (Side == 3) return gradient_of_3<Norm>(rows, dx, dy, magnitude, width);
  constexpr GradientScale scale = Side == 7 ? GradientScale::sixteenth : GradientScale::clamp;
  const std::int32_t length = width + Side - 1;
  std::int16_t* const smoothed = scratch;
  std::int16_t* const differences = scratch + length;
  sum_columns<Side>(rows, smoothed, differences, length, std::make_index_sequence<Side>());
  sobel_filter_row<Side, scale>(smoothed, SobelTaps<Side>::difference, dx, width);
  sobel_filter_row<Side, scale>(differences, SobelTaps<Side>::smooth, dy, width);
  for (std::int32_t x = 0; x < width; ++x) magnitude[x] = Norm::of(dx[x], dy[x]);
}

}  // namespace

template <int Side>
void gradient_l1(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
                 std::uint16_t* magnitude, std::int32_t width) noexcept {
  gradient<Side, L1>(rows, scratch, dx, dy, magnitude, width);
}

template <int Side>
void gradient_l2(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx, std::int16_t* dy,
                 std::uint32_t* magnitude, std::int32_t width) noexcept {
  gradient<Side, L2>(rows, scratch, dx, dy, magnitude, width);
}

template decltype(gradient_l1<3>) gradient_l1<3>;
template decltype(gradient_l1<5>) gradient_l1<5>;
template decltype(gradient_l1<7>) gradient_l1<7>;
template decltype(gradient_l2<3>) gradient_l2<3>;
template decltype(gradient_l2<5>) gradient_l2<5>;
template decltype(gradient_l2<7>) gradient_l2<7>;

}  // namespace straightedge::plain
