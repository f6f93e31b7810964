// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "ransac/subset.hpp"
#include "ransac/triple.hpp"

namespace straightedge::ransac {

/// A plane that was optimised locally, with its MSAC cost.
struct Candidate {
  LinearPlane plane;
  Triple triple;  ///< that made it
  float cost = 0;
};

/// The best planes of a subset.
struct Consensus {
  static constexpr std::uint32_t most = 4;
  std::array<Candidate, most> candidates;
  std::uint32_t count = 0;    ///< of candidates; no two of them alike
  std::uint32_t best = 0;     ///< the cheapest
  std::uint32_t inliers = 0;  ///< those of the best in the subset
  std::uint32_t iterations = 0;
  double probability = 0;  ///< that a hypothesis is made of inliers of the best alone
  bool cancelled = false;  ///< by the trace
};

/// Steps 2 to 5 for the plane of this number.
Consensus find_consensus(const Subset& subset, const RansacOptions& options, std::uint32_t plane) noexcept;

}  // namespace straightedge::ransac
