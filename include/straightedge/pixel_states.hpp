// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace straightedge {

enum class PixelState : std::uint8_t {
  gone = 0,     ///< no edge pixel, or a line has taken it
  waiting = 1,  ///< has not been drawn
  voted = 2,
};

/// A state for each pixel, two bits each; a row begins with a byte of its own.
class PixelStates {
 public:
  static constexpr std::size_t row_bytes(std::int32_t width) noexcept {
    return (static_cast<std::size_t>(width) + 3) / 4;
  }

  PixelStates(std::uint8_t* bytes, std::int32_t width) noexcept : bytes_(bytes), row_(row_bytes(width)) {}

  PixelState at(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<PixelState>((bytes_[byte(x, y)] >> shift(x)) & 3U);
  }
  /// Fetches the pixel's state into the cache.
  void expect(std::int32_t x, std::int32_t y) const noexcept { __builtin_prefetch(bytes_ + byte(x, y), 1); }
  void set(std::int32_t x, std::int32_t y, PixelState state) const noexcept {
    std::uint8_t& four = bytes_[byte(x, y)];
    const std::uint32_t others = four & ~(3U << shift(x));
    four = static_cast<std::uint8_t>(others | static_cast<std::uint32_t>(state) << shift(x));
  }

 private:
  std::size_t byte(std::int32_t x, std::int32_t y) const noexcept {
    return static_cast<std::size_t>(y) * row_ + (static_cast<std::uint32_t>(x) >> 2U);
  }
  static std::uint32_t shift(std::int32_t x) noexcept { return (static_cast<std::uint32_t>(x) & 3U) * 2; }

  std::uint8_t* bytes_;
  std::size_t row_;
};

}  // namespace straightedge
