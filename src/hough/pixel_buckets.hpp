// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_job.hpp"
#include "straightedge/random.hpp"

namespace straightedge::hough {

/// Edge pixels sorted into squares, to draw one of all or one of those near another. Pixels that have
/// left the mask stay listed until `compact`; the caller draws again.
class PixelBuckets {
 public:
  /// Lists the pixels of the mask, which it copies from the edge image. Where `size` is more than there is
  /// room for, none are listed.
  explicit PixelBuckets(HoughJob& job) noexcept;

  /// Drops those that have left the mask. Time: pixels listed, plus squares.
  void compact(HoughJob& job) noexcept;

  std::uint32_t size() const noexcept { return starts_[columns_ * rows_]; }
  std::uint32_t most_nearby() const noexcept { return most_nearby_; }

  PixelPlace draw(Pcg32& random) const noexcept { return points_[random.below(size())]; }

  /// One of the pixels in the square of `centre` and the eight round it, each equally likely.
  PixelPlace draw_near(PixelPlace centre, Pcg32& random) const noexcept;

 private:
  /// The squares of one row of squares follow one another, so three of them are one run of points.
  struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  Run run(std::uint32_t column, std::uint32_t row) const noexcept;
  std::uint32_t bucket_of(std::uint32_t x, std::uint32_t y) const noexcept {
    return y / side_ * columns_ + x / side_;
  }
  void find_most_nearby() noexcept;

  std::uint32_t side_;
  std::uint32_t columns_;
  std::uint32_t rows_;
  std::span<PixelPlace> points_;
  std::span<std::uint32_t> starts_;
  std::uint32_t most_nearby_ = 0;
};

}  // namespace straightedge::hough
