// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/plane_model.hpp"

namespace straightedge::ransac {

/// Some neighbouring pixels of a row, made ready for sums without branches.
struct FrameBlock {
  static constexpr std::int32_t capacity = 256;
  static constexpr std::int32_t lanes = 16;
  float q[capacity];      ///< 1/z
  float limit[capacity];  ///< the gate in 1/z, squared; 0 where there is no reading, or one that has a label
  std::int32_t u0 = 0, v = 0, count = 0;

  /// Pixels from column u0 on. `labels` of the same pixels; what has one takes no part.
  void load(const Readings& readings, std::int32_t first_column, std::int32_t row,
            const std::uint16_t* labels) noexcept;

  /// Pixels that take part.
  std::uint32_t readings() const noexcept;

  /// Adds the pixels within the gate of 1/z = a u + c, as residuals in place of q, with u counted from u0 and
  /// v left out: sums of n, u, uu, r, ur, rr alone.
  void add_inliers(float a, float c, InverseDepthMoments& sums) const noexcept;

  /// Writes the label where a pixel is within the gate. Returns how many.
  std::uint32_t label_inliers(float a, float c, std::uint16_t label, std::uint16_t* labels) const noexcept;
};

}  // namespace straightedge::ransac
