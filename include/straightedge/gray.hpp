// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// The bytes of one pixel, in the order in which they lie in memory.
enum class PixelFormat : std::uint8_t { gray, rgb, bgr, rgba, bgra };

constexpr std::int32_t channels(PixelFormat format) noexcept {
  switch (format) {
    case PixelFormat::gray:
      return 1;
    case PixelFormat::rgb:
    case PixelFormat::bgr:
      return 3;
    case PixelFormat::rgba:
    case PixelFormat::bgra:
      return 4;
  }
  return 0;
}

/// An 8-bit picture in colour, in somebody else's memory.
struct ColorView {
  const std::uint8_t* data = nullptr;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next
  PixelFormat format = PixelFormat::rgb;

  constexpr Size size() const noexcept { return {width, height}; }
  const std::uint8_t* row(std::int32_t y) const noexcept { return data + y * stride; }
  constexpr bool valid() const noexcept {
    return data != nullptr && width > 0 && height > 0 && channels(format) > 0 &&
           stride >= static_cast<std::ptrdiff_t>(width) * channels(format);
  }
};

/// Colour to gray: luma with the weights of ITU-R BT.601, .299 R + .587 G + .114 B.
///
/// Steps
///   1. For each pixel (9798 R + 19235 G + 3735 B + 16384) >> 15. The weights are the three fractions
///      times 2^15 and add up to exactly 2^15, so white stays 255; 16384 rounds to the nearest.
///   2. Alpha is ignored; one channel is copied.
///
/// Errors: `invalid_image` for a view without pixels or with a stride too small, `size_mismatch` when the
/// two sizes differ; `gray` is then untouched. Time linear in pixels; no memory. The views may not overlap.
Status gray_from_color(ColorView color, ImageView<std::uint8_t> gray) noexcept;

}  // namespace straightedge
