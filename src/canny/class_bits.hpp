// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "canny/bounded_fill.hpp"
#include "straightedge/detail/canny_class_plane.hpp"

namespace straightedge {

/// The states of a BoundedFill, two bits a pixel (canny_class_plane.hpp).
struct ClassBits {
  std::uint32_t* words = nullptr;
  std::int32_t width = 0;

  /// The first word of row y, −1 and the height included.
  std::uint32_t* row(std::int32_t y) const noexcept {
    return words + static_cast<std::size_t>(y + 1) * detail::class_words_in_row(width);
  }

  static std::uint32_t get(const std::uint32_t* row, std::int32_t x) noexcept {
    return (row[x >> 4] >> shift(x)) & 3U;
  }

  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept {
    std::uint32_t& word = row(y)[x >> 4];
    word = (word & ~(3U << shift(x))) | (std::uint32_t{state} << shift(x));
  }

  /// Step between the bits of weak_of_three.
  static constexpr std::uint32_t weak_step = 2;

  // Left of column 0 lies the none at the end of the row above.
  std::uint32_t weak_of_three(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint32_t* const word = row(y) + ((x - 1) >> 4);
    const std::uint32_t start = shift(x - 1);
    const std::uint32_t states = (word[0] >> start) | ((word[1] << 1U) << (31 - start));
    return states & ~(states >> 1U) & 0x15U;
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

  // Weak is the state with the first bit alone, pending with the second.
  static bool any_pending(std::uint32_t word) noexcept { return ((word >> 1U) & ~word & 0x55555555U) != 0; }
};

}  // namespace straightedge
