// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "straightedge/depth_kernels.hpp"

/// What depth_kernels.hpp tells of each, for one instruction set.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void keep_readings(const float* inverse, const std::uint16_t* mask, std::int32_t width, float most,
                   float* kept) noexcept;
void build_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                 const DepthCellRows& out, std::uint8_t* counts) noexcept;
void join_cells(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t cells,
                const DepthCellRows& out) noexcept;
void choose_planes(const DepthCellTask& task, const DepthSurfaces& surfaces,
                   DepthCellPlanes& planes) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
