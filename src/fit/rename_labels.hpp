// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_kernels.hpp"
#include "straightedge/image.hpp"

/// Label k becomes by[k].
namespace straightedge::detail {

void rename(std::span<std::uint16_t> cells, std::span<const std::uint16_t> by,
            const DepthKernels& kernels) noexcept;

/// Cells of a picture, which label its pixels: only their planes, and those of cells around, are in a cell.
struct LabelCells {
  Size size;
  std::int32_t side;  ///< pixels
  std::span<const std::uint16_t> labels;
};

/// The same for pixels, where any of them may change: in few places, as a rule.
void rename(ImageView<std::uint16_t> labels, const LabelCells& cells, std::span<const std::uint16_t> by,
            const DepthKernels& kernels) noexcept;

bool changes_nothing(std::span<const std::uint16_t> by) noexcept;

}  // namespace straightedge::detail
