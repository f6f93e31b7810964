// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// The table of one set. The same text for the plain one and those in fast/.
#include "straightedge/ransac_kernels.hpp"

#include "ransac/kernels.hpp"

namespace straightedge {
namespace set = STRAIGHTEDGE_KERNEL_SET;

constinit const RansacKernels STRAIGHTEDGE_OF_SET(_ransac_kernels) = {
    .batch_costs = set::batch_costs,
    .row_cost = set::row_cost,
    .count_rows = set::count_rows,
    .sum_changes = set::sum_changes,
    .inverse = {set::sum_inverse_pixels, set::count_inverse_pixels},
    .raw = {set::sum_raw_pixels, set::count_raw_pixels},
    .sum_points = set::sum_points,
    .count_points = set::count_points,
};

}  // namespace straightedge
