// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"

namespace straightedge::detail {

/// Step 6 of frame_planes.hpp: what planes left over. A cell of level 0 is the middle of something when it
/// and the four around it have readings and no plane: bands along creases have no middle. Pixels of such
/// cells and of cells without a plane up to two cells away get label 0, all others 0xFFFF. `marks`: one entry
/// a cell. Returns the number of middles.
std::uint32_t free_cells(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                         std::span<std::uint16_t> marks, ImageView<std::uint16_t> labels) noexcept;

}  // namespace straightedge::detail
