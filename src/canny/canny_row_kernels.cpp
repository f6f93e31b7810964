// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/canny_row_kernels.hpp"

#include "canny/row_kernels.hpp"

namespace straightedge {

constinit const CannyRowKernels plain_canny_row_kernels = {
    .blur_down = plain::blur_down,
    .blur_along = plain::blur_along,
    .sobel_3 = plain::sobel_3,
    .sobel_5 = plain::sobel_5,
    .sobel_7 = plain::sobel_7,
    .magnitude_l1 = plain::magnitude_l1,
    .magnitude_l2 = plain::magnitude_l2,
    .suppress_l1 = plain::suppress_l1,
    .suppress_l2 = plain::suppress_l2,
};

}  // namespace straightedge
