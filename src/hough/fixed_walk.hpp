// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_memory.hpp"

namespace straightedge::hough {

/// A walk from pixel to pixel along a direction: one pixel a step along the longer axis, a fraction in
/// 16.16 fixed point along the other. OpenCV's HoughLinesP steps so, float division included. Image
/// sides below 2^15 keep every position that is asked for within 32 bits.
class FixedWalk {
 public:
  FixedWalk(PixelPlace start, float along_x, float along_y) noexcept {
    const float ax = along_x < 0 ? -along_x : along_x;
    const float ay = along_y < 0 ? -along_y : along_y;
    flat_ = ax > ay;
    const float ratio = flat_ ? along_y * 65536.0F / ax : along_x * 65536.0F / ay;
    major_step_ = (flat_ ? along_x : along_y) > 0 ? 1 : -1;
    minor_step_ = static_cast<std::int32_t>(detail::round_even(static_cast<double>(ratio)));
    major_ = flat_ ? start.x : start.y;
    minor_ = (flat_ ? start.y : start.x) * 65536 + 32768;
  }

  /// The same walk backwards, from the same start.
  FixedWalk turned() const noexcept {
    FixedWalk other = *this;
    other.major_step_ = -major_step_;
    other.minor_step_ = -minor_step_;
    return other;
  }

  std::int32_t x() const noexcept { return flat_ ? major_ : minor_ >> 16; }
  std::int32_t y() const noexcept { return flat_ ? minor_ >> 16 : major_; }

  void advance() noexcept {
    major_ += major_step_;
    minor_ += minor_step_;
  }

 private:
  bool flat_ = false;
  std::int32_t major_ = 0;
  std::int32_t minor_ = 0;
  std::int32_t major_step_ = 1;
  std::int32_t minor_step_ = 0;
};

}  // namespace straightedge::hough
