// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/plane_model.hpp"

namespace straightedge::ransac {

/// Some neighbouring pixels of a row, looked at where they are.
struct FrameBlock {
  static constexpr std::int32_t capacity = 256;

  /// Pixels from a column on, as many as there are or fit.
  FrameBlock(const Readings& readings, std::int32_t first_column, std::int32_t row) noexcept;

  /// Squared gates in 1/z of all pixels; 0 where there is no reading.
  void limits(float (&limit)[capacity]) const noexcept;

  // `labels` of the same pixels; what has one takes no part.

  /// Pixels that take part.
  std::uint32_t readings(const std::uint16_t* labels) const noexcept;

  /// Adds the pixels within the gate of 1/z = a u + c, as residuals in place of q, with u counted from u0 and
  /// v left out: sums of n, u, uu, r, ur, rr alone.
  void add_inliers(float a, float c, const std::uint16_t* labels, InverseDepthMoments& sums) const noexcept;

  /// Writes the label where a pixel is within the gate. Returns how many.
  std::uint32_t label_inliers(float a, float c, std::uint16_t label, std::uint16_t* labels) const noexcept;

  const float* q;  ///< 1/z
  std::int32_t u0, v, count;
  float constant, metres;  ///< the gate: in 1/z, or along z, whichever is more
};

}  // namespace straightedge::ransac
