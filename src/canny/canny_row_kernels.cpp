// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_row_kernels.hpp"

#include "canny/row_kernels.hpp"

namespace straightedge {

constinit const CannyRowKernels plain_canny_row_kernels = {
    .blur_down = plain::blur_down,
    .blur_along = plain::blur_along,
    .gradient_l1 = {plain::gradient_l1<3>, plain::gradient_l1<5>, plain::gradient_l1<7>},
    .gradient_l2 = {plain::gradient_l2<3>, plain::gradient_l2<5>, plain::gradient_l2<7>},
    .suppress_l1 = plain::suppress_l1,
    .suppress_l2 = plain::suppress_l2,
    .pack_classes = plain::pack_classes,
    .spread_edges = plain::spread_edges,
};

}  // namespace straightedge
