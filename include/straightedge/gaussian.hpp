// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/border.hpp"
#include "straightedge/image.hpp"
#include "straightedge/rounding.hpp"
#include "straightedge/status.hpp"

/// Gaussian blur of 8-bit gray in integers.
///
/// Steps
///   1. The kernel. Its taps are exp(−x² / 2 sigma²), scaled to add up to 1.
///   2. The taps become multiples of 1/256, from the outermost inwards; what rounding one tap loses is
///      carried to the next, and the centre takes the rest. So they add up to exactly 256, and an even
///      area keeps its gray value.
///   3. Down the columns: each row of the output needs sums over the rows above and below it. A sum is at
///      most 255 * 256 and fits 16 bits without rounding.
///   4. Along the row: sums of those sums, at most 255 * 65536. Nothing has been rounded so far, so the
///      order of 3 and 4 does not matter.
///   5. Divided by 65536, rounded to the nearest.
///
/// A Gaussian is the one round filter that splits into a pass over columns and a pass over rows: n + n
/// products a pixel instead of n * n. Equal, bit for bit, to OpenCV 4.6.0's GaussianBlur on 8-bit images
/// (stand-alone ones: on a view into a larger image OpenCV reads the pixels around the view).
///
/// Time O(n) a pixel for n taps; memory one row of 16-bit and one of 32-bit sums.
namespace straightedge {

inline constexpr double max_gaussian_sigma = 50;        ///< pixels
inline constexpr std::int32_t max_gaussian_size = 301;  ///< taps; what sigma 50 asks for

/// How many taps a sigma in [0, 50] asks for: about six sigma, odd. 0 for any other sigma.
constexpr std::int32_t gaussian_size(double sigma) noexcept {
  if (!(sigma >= 0 && sigma <= max_gaussian_sigma)) return 0;
  return static_cast<std::int32_t>(round_half_even(6 * sigma + 1)) | 1;
}

/// Steps 1 and 2. `taps.size()` is the size of the kernel: odd, 1 to 301. sigma in pixels, [0, 50];
/// 0 takes the sigma that suits the size (binomial-like tables up to 9 taps, 0.15 n + 0.35 above).
/// One tap is no blur. Errors: `invalid_option`.
Status make_gaussian_kernel(double sigma, std::span<std::uint16_t> taps) noexcept;

/// The two rows of sums that the blur works on.
struct GaussianScratch {
  std::span<std::uint16_t> columns;  ///< step 3, with the border on both sides
  std::span<std::uint32_t> sums;     ///< step 4

  static constexpr GaussianScratch take(Arena& arena, std::int32_t width, std::int32_t kernel_size) noexcept {
    const auto pixels = static_cast<std::size_t>(width);
    const auto margin = static_cast<std::size_t>(kernel_size - 1);
    GaussianScratch scratch;
    scratch.columns = arena.take<std::uint16_t>(pixels + margin);
    scratch.sums = arena.take<std::uint32_t>(pixels);
    return scratch;
  }
};

/// Steps 3 to 5. `taps`: any odd number (1 to 301) of weights that add up to 256. The kernel may be larger
/// than the image. The views may not overlap.
/// Errors, with `blurred` untouched: `invalid_image`, `size_mismatch`, `invalid_option` (taps or border),
/// `workspace_too_small`.
Status gaussian_blur(GrayView gray, std::span<const std::uint16_t> taps, Border border,
                     const GaussianScratch& scratch, ImageView<std::uint8_t> blurred) noexcept;

}  // namespace straightedge
