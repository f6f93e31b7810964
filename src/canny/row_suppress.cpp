// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "canny/row_kernels.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge::plain {
namespace {

// Steps 2 and 3 of suppress.hpp, pixel x of the row.
template <class M>
bool is_crest(const MagnitudeRows<M>& rows, std::int32_t x) noexcept {
  const M m = rows.here[x];
  switch (gradient_sector_16(rows.dx[x], rows.dy[x])) {
    case GradientSector::horizontal:
      return m > rows.here[x - 1] && m >= rows.here[x + 1];
    case GradientSector::vertical:
      return m > rows.above[x] && m >= rows.below[x];
    case GradientSector::falling:
      return m > rows.above[x - 1] && m > rows.below[x + 1];
    case GradientSector::rising:
      return m > rows.above[x + 1] && m > rows.below[x - 1];
  }
  return false;
}

// Step 1. The first pixel at or right of x that is above `low`, or the width. Most are not: four at once.
template <class M>
std::int32_t next_above(const M* magnitude, std::int32_t x, std::int32_t width, std::uint32_t low) noexcept {
  for (; x + 4 <= width; x += 4) {
    const M* const m = magnitude + x;
    if (m[0] > low || m[1] > low || m[2] > low || m[3] > low) break;
  }
  while (x < width && magnitude[x] <= low) ++x;
  return x;
}

// The rows are a copy, so that writing classes cannot change where they are.
template <class M>
std::uint32_t suppress(const MagnitudeRows<M> rows, MagnitudeThresholds limits, std::uint8_t* classes,
                       std::int32_t width) noexcept {
  const auto low = static_cast<std::uint32_t>(std::max<std::int32_t>(limits.low, 0));
  const auto high = static_cast<std::uint32_t>(std::max<std::int32_t>(limits.high, 0));
  std::memset(classes, no_edge, static_cast<std::size_t>(width));
  std::uint32_t strong = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    if (rows.here[x] <= low) {
      x = next_above(rows.here, x + 1, width, low);
      if (x == width) break;
    }
    if (!is_crest(rows, x)) continue;
    // Step 4.
    const bool is_strong = rows.here[x] > high;
    classes[x] = is_strong ? strong_edge : weak_edge;
    strong += is_strong ? 1 : 0;
  }
  return strong;
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
