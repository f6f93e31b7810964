// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include "canny/bounded_fill.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// The states of a BoundedFill, one byte a pixel.
struct ClassBytes {
  ImageView<std::uint8_t> pixels;

  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept { pixels.at(x, y) = state; }

  std::uint32_t weak_of_three(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint8_t* const pixel = pixels.row(y) + x;
    std::uint32_t weak = pixel[0] == weak_edge ? 2U : 0U;
    if (x > 0 && pixel[-1] == weak_edge) weak |= 1U;
    if (x + 1 < pixels.width && pixel[1] == weak_edge) weak |= 4U;
    return weak;
  }

  std::int32_t next_pending(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint8_t* const row = pixels.row(y);
    for (; x < pixels.width; ++x) {
      while (pixels.width - x >= 4 && !any_pending(row + x)) x += 4;
      if (x < pixels.width && row[x] == pending_edge) return x;
    }
    return pixels.width;
  }

 private:
  // Pending is the state with the second bit and not the first.
  static bool any_pending(const std::uint8_t* four) noexcept {
    std::uint32_t states = 0;
    std::memcpy(&states, four, sizeof states);
    return ((states >> 1U) & ~states & 0x01010101U) != 0;
  }
};

}  // namespace straightedge
