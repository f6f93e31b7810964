// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/canny_rows.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/ransac_options.hpp"

/// Each option with the kernels of a set in it.
namespace bench::speed {

inline straightedge::CannyRowOptions canny_rows_of(const straightedge::KernelSet& set) {
  return {.kernels = set.canny_rows};
}

}  // namespace bench::speed
