// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "canny/bounded_fill.hpp"

namespace straightedge {

/// The states of a BoundedFill, two bits a pixel: four pixels a byte, the leftmost in the lowest bits. A row
/// begins with a byte of its own; pixels beyond the width are none.
struct ClassBits {
  std::uint8_t* bytes = nullptr;
  std::int32_t width = 0;

  std::uint8_t* row(std::int32_t y) const noexcept {
    return bytes + static_cast<std::size_t>(y) * ((static_cast<std::size_t>(width) + 3) / 4);
  }

  std::uint8_t get(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::uint8_t>((row(y)[x >> 2] >> shift(x)) & 3U);
  }

  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept {
    std::uint8_t& four = row(y)[x >> 2];
    const std::uint32_t others = four & ~(3U << shift(x));
    four = static_cast<std::uint8_t>(others | (std::uint32_t{state} << shift(x)));
  }

  std::int32_t next_pending(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint8_t* const fours = row(y);
    for (; x < width; ++x) {
      while ((x & 3) == 0 && x < width && fours[x >> 2] == 0) x += 4;
      if (x < width && ((std::uint32_t{fours[x >> 2]} >> shift(x)) & 3U) == pending_edge) break;
    }
    return x < width ? x : width;
  }

  static std::uint32_t shift(std::int32_t x) noexcept { return 2 * (static_cast<std::uint32_t>(x) & 3U); }
};

}  // namespace straightedge
