// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/subset.hpp"

namespace straightedge::ransac {

/// The best plane of a subset.
struct Consensus {
  LinearPlane plane;
  std::uint32_t inliers = 0;  ///< of the subset; 0: no plane
  std::uint32_t iterations = 0;
  double probability = 0;  ///< that a hypothesis is made of inliers alone
  float cost = 0;          ///< MSAC
  bool cancelled = false;  ///< by the trace
};

/// Steps 2 to 5 for the plane of this number.
Consensus find_consensus(const Subset& subset, const RansacOptions& options, std::uint32_t plane) noexcept;

}  // namespace straightedge::ransac
