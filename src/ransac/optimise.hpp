// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/subset.hpp"

namespace straightedge::ransac {

/// Step 4: least squares of e over the inliers of a wide, a narrower and the very gate. Keeps what costs
/// less; returns the cost.
float optimise(const Subset& subset, const RansacKernels& kernels, float cost, LinearPlane& plane) noexcept;

}  // namespace straightedge::ransac
