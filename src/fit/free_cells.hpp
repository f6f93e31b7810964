// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"

namespace straightedge::detail {

/// Step 6 of frame_planes.hpp: what planes left over. A smallest cell is the middle of something when it and
/// the four around it have readings and no plane: bands along creases have no middle. Such cells and those
/// without a plane up to two cells away get mark 0, all others 0xFFFF. `marks`: one entry a cell. Returns the
/// number of middles.
std::uint32_t free_cells(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                         std::span<std::uint16_t> marks) noexcept;

/// Gives every pixel the mark of its cell.
void mark_pixels(Size cells, std::int32_t side, std::span<const std::uint16_t> marks,
                 ImageView<std::uint16_t> labels) noexcept;

}  // namespace straightedge::detail
