// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// What suppression makes of a pixel.
enum EdgeClass : std::uint8_t {
  no_edge = 0,
  weak_edge = 1,    ///< above the low threshold: an edge if it hangs together with a strong one
  strong_edge = 2,  ///< above the high threshold
};

/// Which neighbours a pixel is compared with: those that its gradient points at and away from.
enum class GradientSector : std::uint8_t {
  horizontal,  ///< left and right
  vertical,    ///< above and below
  falling,     ///< dx and dy of one sign: upper left and lower right
  rising,      ///< of opposite signs: upper right and lower left
};

/// The sector of a gradient: the nearest of the four directions. tan 22.5° is taken as 13573 / 2^15.
constexpr GradientSector gradient_sector(std::int32_t dx, std::int32_t dy) noexcept {
  const std::int64_t across = dx < 0 ? -std::int64_t{dx} : dx;
  const std::int64_t down = dy < 0 ? -std::int64_t{dy} : dy;
  constexpr std::int64_t tan_22 = 13573;           // tan 22.5° * 2^15
  constexpr std::int64_t tan_67 = tan_22 + 65536;  // tan 67.5° = tan 22.5° + 2
  if (down * 32768 < across * tan_22) return GradientSector::horizontal;
  if (down * 32768 > across * tan_67) return GradientSector::vertical;
  return (dx < 0) == (dy < 0) ? GradientSector::falling : GradientSector::rising;
}

/// Non-maximum suppression with the double threshold: of the ridge that an edge makes in the magnitude,
/// only the crest is kept.
///
/// Steps
///   1. Pixels with magnitude <= low are no edge.
///   2. The gradient's sector says which two neighbours lie across the edge. Outside the image is 0.
///   3. The pixel must be larger than both. A ridge two pixels wide, of equal magnitude, must not vanish:
///      in the horizontal and vertical sectors the neighbour to the right or below may be equal. Diagonal
///      ties lose on both sides. (So mirroring an image may move an edge by a pixel where there are ties.)
///   4. What is left is strong if magnitude > high, else weak.
///
/// `low` and `high` are in the magnitude's own units (squares for L2). J. Canny, "A Computational Approach
/// to Edge Detection", IEEE TPAMI 8(6), 1986, doi:10.1109/TPAMI.1986.4767851; the four sectors in place of
/// his interpolation are common practice.
///
/// Errors, with `classes` untouched: `invalid_image`, `size_mismatch`, `invalid_option` (low > high).
/// Time linear in pixels; no memory.
Status suppress_non_maxima(ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                           ImageView<const std::int32_t> magnitude, std::int32_t low, std::int32_t high,
                           ImageView<std::uint8_t> classes) noexcept;

}  // namespace straightedge
