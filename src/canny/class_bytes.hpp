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

  std::uint8_t get(std::int32_t x, std::int32_t y) const noexcept { return pixels.at(x, y); }
  void set(std::int32_t x, std::int32_t y, std::uint8_t state) const noexcept { pixels.at(x, y) = state; }

  std::int32_t next_pending(std::int32_t x, std::int32_t y) const noexcept {
    const std::uint8_t* const row = pixels.row(y);
    for (; x < pixels.width; ++x) {
      // Most pixels are none: eight at once.
      for (; pixels.width - x >= 8 && all_none(row + x); x += 8) {}
      if (x < pixels.width && row[x] == pending_edge) break;
    }
    return x < pixels.width ? x : pixels.width;
  }

  static bool all_none(const std::uint8_t* eight) noexcept {
    std::uint32_t words[2];
    std::memcpy(words, eight, sizeof words);
    return (words[0] | words[1]) == 0;
  }
};

}  // namespace straightedge
