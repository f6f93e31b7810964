// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// The table of one instruction set, as ../canny_row_kernels.cpp. Where the set gains nothing, the plain twin.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include "straightedge/canny_row_kernels.hpp"

#include "base/kernel_set.hpp"
#include "canny/fast/row_kernels.hpp"
#include "canny/row_kernels.hpp"

namespace straightedge {
namespace set = STRAIGHTEDGE_KERNEL_SET;

constinit const CannyRowKernels STRAIGHTEDGE_OF_SET(_canny_row_kernels) = {
    .blur_down = set::blur_down,
    .blur_along = set::blur_along,
    .gradient_l1 = {set::gradient_l1_of_3, plain::gradient_l1<5>, plain::gradient_l1<7>},
    .gradient_l2 = {set::gradient_l2_of_3, plain::gradient_l2<5>, plain::gradient_l2<7>},
    .suppress_l1 = set::suppress_l1,
    .suppress_l2 = set::suppress_l2,
    .pack_classes = set::pack_classes,
    .spread_edges = set::spread_edges,
};

}  // namespace straightedge
#endif
