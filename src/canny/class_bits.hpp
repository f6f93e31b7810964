// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "canny/bounded_fill.hpp"

namespace straightedge {

/// The states of a BoundedFill, two bits a pixel: sixteen pixels a word, the leftmost in the lowest bits. A
/// row begins with a word of its own; pixels beyond the width are none.
struct ClassBits {
  std::uint32_t* words = nullptr;
  std::int32_t width = 0;

  std::uint32_t* row(std::int32_t y) const noexcept {
    return words + static_cast<std::size_t>(y) * ((static_cast<std::size_t>(width) + 15) / 16);
  }

  static std::uint32_t get(const std::uint32_t* row, std::int32_t x) noexcept {
    return (row[x >> 4] >> shift(x)) & 3U;
  }

  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept {
    std::uint32_t& word = row(y)[x >> 4];
    word = (word & ~(3U << shift(x))) | (std::uint32_t{state} << shift(x));
  }

  std::uint32_t weak_of_three(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint32_t* const states = row(y);
    std::uint32_t weak = get(states, x) == weak_edge ? 2U : 0U;
    if (x > 0 && get(states, x - 1) == weak_edge) weak |= 1U;
    if (x + 1 < width && get(states, x + 1) == weak_edge) weak |= 4U;
    return weak;
  }

  std::int32_t next_pending(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint32_t* const states = row(y);
    for (; x < width; ++x) {
      while ((x & 15) == 0 && x < width && !any_pending(states[x >> 4])) x += 16;
      if (x < width && get(states, x) == pending_edge) return x;
    }
    return width;
  }

 private:
  static std::uint32_t shift(std::int32_t x) noexcept { return 2 * (static_cast<std::uint32_t>(x) & 15U); }

  // Pending is the state with the second bit and not the first.
  static bool any_pending(std::uint32_t word) noexcept { return ((word >> 1U) & ~word & 0x55555555U) != 0; }
};

}  // namespace straightedge
