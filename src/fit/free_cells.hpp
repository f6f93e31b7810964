// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// Step 6 of frame_planes.hpp: what planes left over. A smallest cell is the middle of something when it and
/// the four around it have readings and no plane: bands along creases have no middle. Such cells and those
/// without a plane up to two cells away get mark 0, all others 0xFFFF. Returns the number of middles.
std::uint32_t free_cells(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                         ImageView<std::uint16_t> marks) noexcept;

/// Where a picture has room for the marks of its cells: where the first row of pixels of each row of cells
/// begins.
ImageView<std::uint16_t> marks_in(ImageView<std::uint16_t> labels, const DepthCells& cells) noexcept;

/// Gives every pixel the mark of its cell, of those that are in the picture.
void spread_marks(std::int32_t side, ImageView<std::uint16_t> labels) noexcept;

}  // namespace straightedge::detail
