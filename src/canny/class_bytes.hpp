// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "canny/bounded_fill.hpp"
#include "canny/four_pixels.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// The states of a BoundedFill, one byte a pixel.
struct ClassBytes {
  ImageView<std::uint8_t> pixels;

  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept { pixels.at(x, y) = state; }

  /// Step between the bits of weak_of_three.
  static constexpr std::uint32_t weak_step = 8;

  std::uint32_t weak_of_three(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint8_t* const pixel = pixels.row(y) + x;
    if (x > 0 && x + 2 < pixels.width) return weak_in(load_four_bytes(pixel - 1)) & 0x00FFFFFFU;
    std::uint32_t weak = pixel[0] == weak_edge ? 1U << weak_step : 0;
    if (x > 0 && pixel[-1] == weak_edge) weak |= 1U;
    if (x + 1 < pixels.width && pixel[1] == weak_edge) weak |= 1U << (2 * weak_step);
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
  // One bit for each of four pixels. Weak is the state with the first bit alone, pending with the second.
  static std::uint32_t weak_in(std::uint32_t states) noexcept {
    return states & ~(states >> 1U) & 0x01010101U;
  }
  static bool any_pending(const std::uint8_t* four) noexcept {
    const std::uint32_t states = load_four_bytes(four);
    return ((states >> 1U) & ~states & 0x01010101U) != 0;
  }
};

}  // namespace straightedge
