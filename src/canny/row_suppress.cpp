// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "canny/row_kernels.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge::plain {
namespace {

/// A short pipeline loses little by a branch that nobody can foresee, such as whether a pixel is a crest.
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
constexpr bool cheap_branches = true;
#else
constexpr bool cheap_branches = false;
#endif

/// Steps 2 and 3 of suppress.hpp as a table, one entry a sector: rows shifted so that element x is the
/// neighbour of pixel x, and what a pixel must be more than its second neighbour.
template <class M>
struct Neighbours {
  const M* first;
  const M* second;
  std::int32_t least;
};

template <class M>
bool is_crest(const Neighbours<M>& across, std::int32_t magnitude, std::int32_t x) noexcept {
  const auto first = static_cast<std::int32_t>(across.first[x]);
  const auto second = static_cast<std::int32_t>(across.second[x]);
  return (magnitude > first) & (magnitude >= second + across.least);
}

// Step 2: entry of the table. For what a Sobel operator gives, and unless dx and dy are 0 both, rounding the
// product with the tangent down does not change the sector. tan 22.5 degrees is 13573 / 2^15, tan 67.5 is
// 2 more.
std::int32_t sector_of(std::int32_t dx, std::int32_t dy) noexcept {
  const std::int32_t across = dx < 0 ? -dx : dx, down = dy < 0 ? -dy : dy;
  const std::int32_t flat = across * (2 * 13573) >> 16;
  const std::int32_t steepness = (down > flat ? 1 : 0) + (down > 2 * across + flat ? 1 : 0);
  return (dx ^ dy) < 0 ? steepness + 3 : steepness;
}

// The rows are a copy, so that writing classes cannot change where they are.
template <class M>
std::uint32_t suppress(const MagnitudeRows<M> rows, MagnitudeThresholds limits, std::uint8_t* classes,
                       std::int32_t width) noexcept {
  static_assert(weak_edge == 1 && strong_edge == 2);
  const Neighbours<M> horizontal{rows.here - 1, rows.here + 1, 0};
  const Neighbours<M> vertical{rows.above, rows.below, 0};
  const Neighbours<M> falling{rows.above - 1, rows.below + 1, 1};
  const Neighbours<M> rising{rows.above + 1, rows.below - 1, 1};
  const Neighbours<M> across[] = {horizontal, falling, vertical, horizontal, rising, vertical};
  limits = {std::max<std::int32_t>(limits.low, 0), std::max<std::int32_t>(limits.high, 0)};
  const auto low = static_cast<std::uint32_t>(limits.low);
  std::memset(classes, no_edge, static_cast<std::size_t>(width));
  std::int32_t strong = 0;
  for (std::int32_t x = 0; x < width; x += 4) {
    const M* const m = rows.here + x;  // may be read beyond the row
    if (m[0] <= low && m[1] <= low && m[2] <= low && m[3] <= low) continue;
    const std::int32_t end = std::min<std::int32_t>(x + 4, width);
    for (std::int32_t i = x; i < end; ++i) {
      if (rows.here[i] <= low) continue;
      const auto magnitude = static_cast<std::int32_t>(rows.here[i]);
      const int kept = is_crest(across[sector_of(rows.dx[i], rows.dy[i])], magnitude, i) ? 1 : 0;
      if (cheap_branches && kept == 0) continue;
      const int found = kept << static_cast<unsigned>(magnitude > limits.high);
      classes[i] = static_cast<std::uint8_t>(found);
      strong += found >> 1U;
    }
  }
  return static_cast<std::uint32_t>(strong);
}

}  // namespace

std::uint32_t suppress_l1(const MagnitudeRows<std::uint16_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept {
  return suppress(rows, limits, classes, width);
}

std::uint32_t suppress_l2(const MagnitudeRows<std::uint32_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept {
  return suppress(rows, limits, classes, width);
}

}  // namespace straightedge::plain
