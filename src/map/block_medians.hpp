// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "map/picture_rows.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// The medians of the blocks side by side whose upper edge is row `top`, as many as `medians` has elements;
/// of an even number of pixels the upper one. Blocks of at most 4x4 pixels.
void block_medians(GrayView gray, std::int32_t top, Size block, const PictureRowKernels& kernels,
                   std::vector<std::uint8_t>& medians);

}  // namespace straightedge
