// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

std::int32_t label_row(const float* q, const DepthBlock& block, float first, float slope,
                       std::uint16_t* __restrict out) noexcept {
  const float limit = block.limit;
  const std::uint16_t label = block.label;
  std::int32_t count = 0;
  for (std::int32_t x = 0; x < block.width; ++x) {
    const float r = q[x] - (first + slope * static_cast<float>(x));
    const bool near = (r < limit) & (r > -limit) & (q[x] > 0);
    out[x] = near ? label : std::uint16_t{0};
    count += near ? 1 : 0;
  }
  return count;
}

}  // namespace

std::int32_t label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept {
  // Labels might be the block, for all the compiler knows.
  const DepthBlock b = block;
  const float slope = static_cast<float>(b.along);
  std::int32_t count = 0;
  for (std::int32_t y = 0; y < b.height; ++y, labels += stride) {
    const float first = static_cast<float>(b.at + b.down * y);
    count += label_row(b.rows.first + y * b.rows.stride, b, first, slope, labels);
  }
  return count;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
