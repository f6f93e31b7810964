// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge::ransac {

/// The sum of partial sums by a fixed tree: the halves onto one another until one is left. A power of two of
/// lanes.
template <std::int32_t lanes>
double fold(const float (&partial)[lanes]) noexcept {
  double sums[lanes];
  for (std::int32_t l = 0; l < lanes; ++l) sums[l] = static_cast<double>(partial[l]);
  for (std::int32_t half = lanes / 2; half > 0; half /= 2)
    for (std::int32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

}  // namespace straightedge::ransac
