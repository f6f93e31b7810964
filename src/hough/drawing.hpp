// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hough/opencv_generator.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/random.hpp"

namespace straightedge::hough {

/// Draws the listed pixels, each once. Which pixel comes when depends on their number alone, not on what
/// becomes of them: so some are drawn before they are asked for, and what is known of them is in the cache by
/// then.
class Drawing {
 public:
  explicit Drawing(const HoughJob& job) noexcept
      : job_(job),
        states_(job.memory.mask.data(), job.edges.width),
        points_(job.memory.points.data()),
        not_drawn_(job.result.edge_pixels),
        left_(job.result.edge_pixels),
        pcg_(job.options.seed) {
    for (std::uint32_t k = 1; k <= ahead; ++k) ahead_[(left_ - k) % ahead] = draw();
  }

  /// How many will still come.
  std::uint32_t left() const noexcept { return left_; }

  PixelPlace next() noexcept {
    PixelPlace& place = ahead_[--left_ % ahead];
    const PixelPlace pixel = place;
    place = draw();
    return pixel;
  }

 private:
  static constexpr std::uint32_t ahead = 16;

  /// The last of those not drawn takes the place of the one drawn.
  PixelPlace draw() noexcept {
    if (not_drawn_ == 0) return {};
    const bool as_opencv = job_.options.generator == HoughGenerator::opencv;
    const std::uint32_t index = as_opencv ? opencv_.next() % not_drawn_ : pcg_.below(not_drawn_);
    const PixelPlace pixel = points_[index];
    points_[index] = points_[--not_drawn_];
    states_.expect(pixel.x, pixel.y);
    if (!job_.memory.firsts.empty()) expect_window(pixel);
    return pixel;
  }

  void expect_window(PixelPlace pixel) const noexcept {
    const auto width = static_cast<std::size_t>(job_.edges.width);
    __builtin_prefetch(&job_.memory.firsts[pixel.y * width + pixel.x]);
  }

  const HoughJob& job_;
  PixelStates states_;
  PixelPlace* points_;
  std::uint32_t not_drawn_;
  std::uint32_t left_;
  Pcg32 pcg_;
  OpencvGenerator opencv_;
  PixelPlace ahead_[ahead];
};

}  // namespace straightedge::hough
