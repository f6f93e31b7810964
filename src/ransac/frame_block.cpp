// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_block.hpp"

#include <bit>

namespace straightedge::ransac {

FrameBlock::FrameBlock(const Readings& readings, std::int32_t first_column, std::int32_t row) noexcept
    : q(own), u0(first_column), v(row), constant(readings.constant()), metres(readings.metres()) {
  const std::int32_t left = readings.size().width - first_column;
  count = left < capacity ? left : capacity;
  if (!readings.is_raw()) {
    q = readings.frame.row(row) + first_column;
    return;
  }
  const std::uint16_t* const raw = readings.raw.row(row) + first_column;
  for (std::int32_t i = 0; i < count; ++i) own[i] = inverse_of(raw[i], readings.scale);
}

void FrameBlock::limits(float (&limit)[capacity]) const noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float wide = wide_of(q[i], constant, metres);
    const auto squared = std::bit_cast<std::int32_t>(wide * wide);
    limit[i] = std::bit_cast<float>(squared & -is_above(q[i], wide));
  }
}

}  // namespace straightedge::ransac
