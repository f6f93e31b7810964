// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/ransac_kernels.hpp"

namespace straightedge::ransac {

/// Residuals in units of the gate: 1 is the border between inlier and outlier for every kind of input and
/// gate.
using Rows = RansacRows;
using Coefficients = RansacCoefficients;

/// Interleaved partial sums of every sum over rows: row i adds to sum i % 16, and the sums are added up
/// pairwise, 8 apart, 4, 2, 1. Kernels for any width of registers up to 16 floats give these bits.
inline constexpr std::uint32_t row_lanes = 16;

constexpr std::uint32_t padded(std::uint32_t count) noexcept {
  return (count + row_lanes - 1) / row_lanes * row_lanes;
}

/// The MSAC cost: sum of min(residual², 1). A row of zeros costs nothing.
float msac_cost(const Rows& rows, const Coefficients& plane) noexcept;

/// How many of the first `readings` rows have residual² < 1.
std::uint32_t count_inliers(const Rows& rows, std::uint32_t readings, const Coefficients& plane) noexcept;

}  // namespace straightedge::ransac
