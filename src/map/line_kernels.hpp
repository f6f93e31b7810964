// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "map/picture_rows.hpp"

// What the tables of picture_rows.hpp have from other files of kernels.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void edge_magnitudes(EdgeBatch& batch, bool squared) noexcept;

void edge_places(EdgeBatch& batch) noexcept;

void find_inside(const StripRule& strip, StripBatch& batch) noexcept;

void sample(const SampleWay& way, const double* steps, std::int32_t count, double* gray) noexcept;

void read_nearest(const SampleWay& way, std::int32_t count, std::uint8_t* gray) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
