// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_cells.hpp"

namespace straightedge::hough {
namespace {

/// Cells of the readings that take part.
void build(const DepthInput& input, const DepthKernels& kernels, std::span<float> pixels,
           DepthCells& cells) noexcept {
  const Size size = input.inverse_depth.size();
  for (std::int32_t top = 0; top < size.height; top += hough_patch_side) {
    const std::int32_t rest = size.height - top, height = rest < hough_patch_side ? rest : hough_patch_side;
    const ImageView<float> band(pixels.data(), {size.width, height});
    for (std::int32_t v = 0; v < height; ++v) {
      const std::uint16_t* mask = input.mask.data == nullptr ? nullptr : input.mask.row(top + v);
      kernels.keep_readings(input.inverse_depth.row(top + v), mask, size.width, largest_reading, band.row(v));
    }
    cells.build_row(band, top / hough_patch_side, kernels);
  }
}

}  // namespace

PatchLevels sum_squares(const DepthInput& input, const DepthCells* made, const DepthKernels& kernels,
                        detail::HoughPatchMemory& memory) noexcept {
  const bool serve = made != nullptr && input.mask.data == nullptr && made->finest() <= 1 &&
                     made->size(1) == memory.cells.size(1);
  if (!serve) build(input, kernels, memory.pixels, memory.cells);
  const DepthCells& cells = serve ? *made : memory.cells;
  join_cells(cells.rows(3, 0), cells.size(3), memory.largest, kernels);
  return {{cells.rows(1, 0), cells.rows(2, 0), cells.rows(3, 0), memory.largest},
          input.inverse_depth.size(),
          cells.middle_u(),
          cells.middle_v()};
}

}  // namespace straightedge::hough
