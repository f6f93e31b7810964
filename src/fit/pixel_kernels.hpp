// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "straightedge/depth_kernels.hpp"

/// What depth_kernels.hpp tells of each, for one instruction set.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void mark_whole(const DepthWholeCells& task, const DepthSurfaces& surfaces, std::uint16_t* labels) noexcept;
void spread_labels(const std::uint16_t* cells, std::int32_t side, std::int32_t width,
                   std::uint16_t* labels) noexcept;
std::int32_t label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept;
void rename_row(std::uint16_t* labels, std::int32_t count, const std::uint16_t* by,
                std::int32_t names) noexcept;
void choose(const DepthChoice& square, std::uint16_t* labels) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
