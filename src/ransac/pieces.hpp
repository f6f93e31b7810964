// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "ransac/readings.hpp"
#include "straightedge/ransac_planes.hpp"

namespace straightedge::ransac {

/// Splits each plane's readings (labels 1 to `planes`) into connected pieces: cells that touch, at a side or
/// a corner. Cells are pixels, or squares of piece_cell_m on the plane. The largest piece keeps the plane's
/// label, others become planes behind the present ones, in order; pieces below `least` get label 0. Returns
/// how many planes there are then; `full` says that `out` had no room for a piece.
std::uint32_t split_pieces(const Readings& readings, const detail::RansacPlanesMemory& memory, double cell_m,
                           std::uint32_t least, std::uint32_t planes, std::span<FoundPlane> out,
                           bool& full) noexcept;

}  // namespace straightedge::ransac
