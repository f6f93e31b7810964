// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_patch_kernels.hpp"
#include "straightedge/image.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::hough {

/// 1/z, 0 where there is no reading; where the mask (which may be null) is not 0, there is none either.
struct DepthInput {
  ImageView<const float> inverse_depth;
  ImageView<const std::uint16_t> mask;
};

/// A reading of 1/z is above 0 and at most 1e4: farther than a tenth of a millimetre.
inline constexpr float largest_reading = 1e4F;
inline bool is_reading(float q) noexcept {
  return q > 0 && q <= largest_reading;
}
inline bool is_reading(const DepthInput& input, std::int32_t x, std::int32_t y) noexcept {
  return is_reading(input.inverse_depth.at(x, y)) && (input.mask.data == nullptr || input.mask.at(x, y) == 0);
}

/// Sums of the cells of hough_patch_side squared, row by row, u and v from pixel (0, 0). One pass over the
/// picture. Within a cell q counts from one of its readings, so that float sums lose nothing that matters.
void sum_cells(const DepthInput& input, const HoughPatchKernels& kernels,
               std::span<InverseDepthMoments> cells) noexcept;

/// Cells of twice the side from four (at the borders fewer) of a level with this many columns and rows.
void sum_four(std::span<const InverseDepthMoments> fine, Size fine_cells,
              std::span<InverseDepthMoments> coarse) noexcept;

}  // namespace straightedge::hough
