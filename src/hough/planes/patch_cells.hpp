// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "straightedge/depth_cells.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/image.hpp"

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

/// Squares of 8, 16, 32, 64 pixels, row by row.
struct PatchLevels {
  static constexpr std::int32_t count = 4;
  std::array<DepthCellRows, count> rows;
  Size size;  ///< of the picture
  double middle_u = 0, middle_v = 0;

  /// How many squares there are across and down.
  Size squares(std::int32_t level) const noexcept { return DepthCells::size_of(size, level + 1); }
  const float* readings(std::int32_t level) const noexcept {
    return rows[static_cast<std::size_t>(level)].first;
  }
  DepthCell at(std::int32_t level, std::size_t place) const noexcept {
    const DepthCellRows& all = rows[static_cast<std::size_t>(level)];
    return cell_at({all.first + place, all.apart});
  }
};

/// Step 1 of hough_plane_patches.hpp. Cells that were made of the same picture (which may be null) serve, if
/// they are small enough and nothing is masked; else the memory's own are made, in one pass over the picture.
PatchLevels sum_squares(const DepthInput& input, const DepthCells* made, const DepthKernels& kernels,
                        detail::HoughPatchMemory& memory) noexcept;

}  // namespace straightedge::hough
