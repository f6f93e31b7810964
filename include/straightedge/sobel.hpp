// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/border.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

/// The gradient of an 8-bit image by Sobel's operator: a difference along one axis, smoothed along the
/// other, so that noise counts less than edges.
///
///   side   smoothing          difference         largest value
///   3      1 2 1              -1 0 1             1 020
///   5      1 4 6 4 1          -1 -2 0 2 1        12 240
///   7      1 6 15 20 15 6 1   -1 -4 -5 0 5 4 1   163 200
///
/// Steps
///   1. Down the columns, for each row of the output: the smoothed sums and the differences.
///   2. Along the row: dx is the difference of the smoothed sums (right minus left), dy the smoothed
///      sum of the differences (below minus above).
///   3. Into 16 bits. Side 7 does not fit: `clamp` cuts at ±32768, `sixteenth` divides by 16 and rounds
///      halves to even.
///
/// I. Sobel and G. Feldman, "A 3x3 isotropic gradient operator for image processing", 1968 (talk at the
/// Stanford Artificial Intelligence Project). Equal, bit for bit, to OpenCV 4.6.0's Sobel with 16-bit
/// output; `replicate` and, for side 7, `sixteenth` are what its Canny uses.
///
/// Time O(side) a pixel; memory two rows of 16-bit sums.
namespace straightedge {

enum class GradientScale : std::uint8_t {
  clamp,      ///< values as they are, cut to 16 bits
  sixteenth,  ///< a sixteenth of them, for side 7 inside Canny
};

constexpr bool is_sobel_aperture(int aperture) noexcept {
  return aperture == 3 || aperture == 5 || aperture == 7;
}

/// The two rows of column sums, with the border on both sides.
struct SobelScratch {
  std::span<std::int16_t> smoothed;
  std::span<std::int16_t> difference;

  static constexpr SobelScratch take(Arena& arena, std::int32_t width, int aperture) noexcept {
    const auto length = static_cast<std::size_t>(width) + static_cast<std::size_t>(aperture - 1);
    SobelScratch scratch;
    scratch.smoothed = arena.take<std::int16_t>(length);
    scratch.difference = arena.take<std::int16_t>(length);
    return scratch;
  }
};

/// Errors, with dx and dy untouched: `invalid_image`, `size_mismatch`, `invalid_option` (aperture, scale or
/// border), `workspace_too_small`. The views may not overlap.
Status sobel(GrayView gray, int aperture, Border border, GradientScale scale, const SobelScratch& scratch,
             ImageView<std::int16_t> dx, ImageView<std::int16_t> dy) noexcept;

}  // namespace straightedge
