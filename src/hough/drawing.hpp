// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hough/opencv_generator.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/random.hpp"

namespace straightedge::hough {

/// Draws the listed pixels, each once. Which pixel comes when depends on their number alone, not on what
/// becomes of them: so one may draw ahead.
class Drawing {
 public:
  explicit Drawing(HoughJob& job) noexcept
      : as_opencv_(job.options.generator == HoughGenerator::opencv),
        points_(job.memory.points.data()),
        left_(job.result.edge_pixels),
        pcg_(job.options.seed) {}

  std::uint32_t left() const noexcept { return left_; }

  /// The last of those left takes the place of the one drawn.
  PixelPlace next() noexcept {
    const std::uint32_t index = as_opencv_ ? opencv_.next() % left_ : pcg_.below(left_);
    const PixelPlace pixel = points_[index];
    points_[index] = points_[--left_];
    return pixel;
  }

 private:
  bool as_opencv_;
  PixelPlace* points_;
  std::uint32_t left_;
  Pcg32 pcg_;
  OpencvGenerator opencv_;
};

}  // namespace straightedge::hough
