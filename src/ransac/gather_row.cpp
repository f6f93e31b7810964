// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

std::uint32_t gather_row(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                         const GatheredReadings& out) noexcept {
  std::uint32_t k = 0;
  for (std::int32_t c = 0; c < columns; ++c) {
    // Written in any case; what is no reading the next one overwrites.
    out.u[k] = row.u[c] - u0;
    out.v[k] = row.v[c] - v0;
    out.q[k] = row.q[c];
    out.w[k] = row.w[c];
    k += row.q[c] > 0 ? 1U : 0U;
  }
  return k;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
