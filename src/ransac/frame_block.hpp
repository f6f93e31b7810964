// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/readings.hpp"

namespace straightedge::ransac {

/// Some neighbouring pixels of a row, looked at where they are.
struct FrameBlock {
  static constexpr std::int32_t capacity = 128;

  /// Pixels from a column on, as many as there are or fit.
  FrameBlock(const Readings& readings, std::int32_t first_column, std::int32_t row) noexcept;
  FrameBlock(const FrameBlock&) = delete;
  FrameBlock& operator=(const FrameBlock&) = delete;

  /// Squared gates in 1/z of all pixels; 0 where there is no reading.
  void limits(float (&limit)[capacity]) const noexcept;

  float own[capacity];  ///< 1/z of raw depth
  const float* q;       ///< 1/z
  std::int32_t u0, v, count;
  float constant, metres;  ///< the gate: in 1/z, or along z, whichever is more
};

}  // namespace straightedge::ransac
