// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void add_square(const DepthRows& corner, std::int32_t left, std::int32_t top, const std::uint16_t* labels,
                double* sums) noexcept {
  const float* row = corner.first;
  for (std::int32_t y = 0; y < DepthChoice::side; ++y, row += corner.stride) {
    const double v = top + y;
    for (std::int32_t x = 0; x < DepthChoice::side; ++x) {
      const std::uint16_t label = *labels++;
      if (label == 0) continue;
      double* sum = sums + 10 * (label - 1);
      const double u = left + x, q = static_cast<double>(row[x]);
      const double terms[] = {1, u, v, u * u, u * v, v * v, q, u * q, v * q, q * q};
      for (int i = 0; i < 10; ++i) sum[i] += terms[i];
    }
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
