// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::hough {

/// 1/z, 0 where there is no reading; where the mask (which may be null) is not 0, there is none either.
struct DepthInput {
  ImageView<const float> inverse_depth;
  ImageView<const std::uint16_t> mask;
};

/// For each column of the picture what one row of cells adds up, relative to a 1/z near the cell's own: so
/// float sums lose nothing that matters.
struct ColumnSums {
  std::span<float> reference;  ///< the same for all columns of a cell
  std::span<float> q, qq, vq;  ///< v counts from the row of cells' first row
  std::span<std::uint32_t> seen;  ///< bit v: there is a reading in that row
};

/// Sums of the cells of hough_patch_side squared, row by row, u and v from pixel (0, 0). One pass over the picture.
void sum_cells(const DepthInput& input, const ColumnSums& columns,
               std::span<InverseDepthMoments> cells) noexcept;

/// Cells of twice the side from four (at the borders fewer) of a level with this many columns and rows.
void sum_four(std::span<const InverseDepthMoments> fine, Size fine_cells,
              std::span<InverseDepthMoments> coarse) noexcept;

}  // namespace straightedge::hough
