// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_memory.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// The votes that a run has left, whatever the cells look like in memory: one row an angle, one column a
/// distance. Row n is theta = min_theta + n * theta_step. Column r is rho = (r - (distances - 1) / 2) *
/// rho_step, from the first pixel or (randomized) from the centre.
class HoughVotesView {
 public:
  HoughVotesView() = default;
  HoughVotesView(Size picture, HoughMethod method, const HoughGrid& grid, const HoughMemory& memory) noexcept
      : width(grid.distances), height(grid.angles), picture_(picture), method_(method), memory_(memory) {}

  std::int32_t width = 0;   ///< distances
  std::int32_t height = 0;  ///< angles

  bool valid() const noexcept { return width > 0; }
  bool contains(std::int32_t r, std::int32_t n) const noexcept {
    return r >= 0 && n >= 0 && r < width && n < height;
  }

  /// Votes for distance r at angle n; 0 where the progressive method has no cell, because no line of that
  /// angle through the picture is so far away.
  std::int32_t at(std::int32_t r, std::int32_t n) const noexcept;

 private:
  Size picture_;
  HoughMethod method_ = HoughMethod::standard;
  HoughMemory memory_;
};

/// The edge pixels that no segment took.
class HoughRemainingView {
 public:
  HoughRemainingView(Size picture, HoughMethod method, const HoughMemory& memory) noexcept
      : picture_(picture), method_(method), memory_(memory) {}

  bool at(std::int32_t x, std::int32_t y) const noexcept;

 private:
  Size picture_;
  HoughMethod method_;
  HoughMemory memory_;
};

}  // namespace straightedge
