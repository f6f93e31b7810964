// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge {

constinit const PlaneSearchKernels STRAIGHTEDGE_OF_SET(_plane_search_kernels) = {
    .try_triples = STRAIGHTEDGE_KERNEL_SET::try_triples,
    .find_inliers = STRAIGHTEDGE_KERNEL_SET::find_inliers,
    .sum_inliers = STRAIGHTEDGE_KERNEL_SET::sum_inliers,
    .gather_row = STRAIGHTEDGE_KERNEL_SET::gather_row,
    .take_cells = STRAIGHTEDGE_KERNEL_SET::take_cells,
    .mask_cells = STRAIGHTEDGE_KERNEL_SET::mask_cells,
    .count_readings = STRAIGHTEDGE_KERNEL_SET::count_readings,
    .mark_hits = STRAIGHTEDGE_KERNEL_SET::mark_hits,
    .keep_dense = STRAIGHTEDGE_KERNEL_SET::keep_dense,
    .empty_marked = STRAIGHTEDGE_KERNEL_SET::empty_marked,
    .sum_marked = STRAIGHTEDGE_KERNEL_SET::sum_marked,
};

}  // namespace straightedge
