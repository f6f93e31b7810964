// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge {

constinit const PlaneSearchKernels STRAIGHTEDGE_OF_SET(_plane_search_kernels) = {
    .try_triples = STRAIGHTEDGE_KERNEL_SET::try_triples,
    .find_inliers = STRAIGHTEDGE_KERNEL_SET::find_inliers,
    .sum_inliers = STRAIGHTEDGE_KERNEL_SET::sum_inliers,
    .take_readings = STRAIGHTEDGE_KERNEL_SET::take_readings,
    .weigh = STRAIGHTEDGE_KERNEL_SET::weigh,
    .count_readings = STRAIGHTEDGE_KERNEL_SET::count_readings,
    .mark_hits = STRAIGHTEDGE_KERNEL_SET::mark_hits,
    .keep_dense = STRAIGHTEDGE_KERNEL_SET::keep_dense,
    .sum_marked = STRAIGHTEDGE_KERNEL_SET::sum_marked,
    .take_cheaper = STRAIGHTEDGE_KERNEL_SET::take_cheaper,
};

}  // namespace straightedge
