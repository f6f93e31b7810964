// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "straightedge/depth_kernels.hpp"

/// What depth_kernels.hpp tells of each, for one instruction set.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void sum_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, DepthCellSums* sums) noexcept;
void whole_cells(const DepthCellSums* sums, std::int32_t side, std::int32_t cells, float left, float top,
                 const DepthCellRows& out) noexcept;
void join_cells(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t cells,
                const DepthCellRows& out) noexcept;
void choose_planes(const DepthCellTask& task, const DepthSurfaces& surfaces,
                   DepthCellPlanes& planes) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
