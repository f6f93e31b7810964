// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hough/opencv_generator.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/random.hpp"

namespace straightedge::hough {

/// Draws the listed pixels, each once. Which pixel comes when depends on their number alone, not on what
/// becomes of them: so some are drawn before they are asked for, and their states are in the cache by then.
class Drawing {
 public:
  explicit Drawing(const HoughJob& job) noexcept
      : states_(job.memory.mask.data(), job.edges.width),
        points_(job.memory.points.data()),
        left_(job.result.edge_pixels),
        not_drawn_(left_),
        as_opencv_(job.options.generator == HoughGenerator::opencv),
        pcg_(job.options.seed) {}

  /// How many will still come.
  std::uint32_t left() const noexcept { return left_; }

  PixelPlace next() noexcept {
    if (left_ == not_drawn_) draw();
    return points_[--left_];
  }

 private:
  static constexpr std::uint32_t ahead = 32;

  void draw() noexcept;

  template <class Below>
  void draw_some(const Below& below) noexcept;

  PixelStates states_;
  PixelPlace* points_;
  std::uint32_t left_;       ///< points below are still to come
  std::uint32_t not_drawn_;  ///< points below are in no order yet
  bool as_opencv_;
  Pcg32 pcg_;
  OpencvGenerator opencv_;
};

}  // namespace straightedge::hough
