// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/kernel_set.hpp"
#include "straightedge/ransac_kernels.hpp"

// The functions of one set; ransac_kernels.hpp says what each does.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void batch_costs(const RansacRows& rows, const RansacBatch& planes, float* costs) noexcept;
float row_cost(const RansacRows& rows, const RansacCoefficients& plane) noexcept;
std::uint32_t count_rows(const RansacRows& rows, const RansacCoefficients& plane) noexcept;
RansacChangeSums sum_changes(const RansacRows& rows, const RansacCoefficients& plane, const float* s,
                             const float* t, float limit) noexcept;
RansacPixelSums sum_inverse_pixels(const RansacPixels<float>& row) noexcept;
std::uint32_t count_inverse_pixels(const RansacPixels<float>& row) noexcept;
RansacPixelSums sum_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept;
std::uint32_t count_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept;
RansacPointSums sum_points(const RansacPoints& points) noexcept;
std::uint32_t count_points(const RansacPoints& points) noexcept;

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
