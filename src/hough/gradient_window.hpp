// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/gradient_view.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::hough {

/// Angles [first, end) and then [0, wrapped): an interval of directions modulo pi.
struct AngleWindow {
  std::int32_t first = 0;
  std::int32_t end = 0;
  std::int32_t wrapped = 0;
};

/// The window that begins at angle `first`, in [0, half_turn).
inline AngleWindow window_from(const HoughJob& job, std::int32_t first, std::int32_t count) noexcept {
  const std::int32_t period = job.grid.half_turn;
  const std::int32_t last = first + count;
  const std::int32_t angles = job.grid.angles;
  AngleWindow window{first, last < period ? last : period, last < period ? 0 : last - period};
  if (window.first > angles) window.first = angles;
  if (window.end > angles) window.end = angles;
  if (window.wrapped > angles) window.wrapped = angles;
  return window;
}

/// The angles that pixel (x, y) votes for. Depends on the options and the pixel alone, so that votes
/// can be taken off as they were cast. Where theta_step does not divide pi, the window's seam at
/// pi is off by half a step at most.
inline AngleWindow angle_window(const HoughJob& job, std::int32_t x, std::int32_t y) noexcept {
  const AngleWindow everything{0, job.grid.angles, 0};
  if (!job.windowed()) return everything;
  const double dx = job.gradients.dx.at(x, y);
  const double dy = job.gradients.dy.at(x, y);
  if (dx == 0 && dy == 0) return everything;
  const auto step = static_cast<double>(job.grid.theta_step);
  const std::int32_t period = job.grid.half_turn;
  const std::int32_t count = hough_window_angles(job.grid, job.options);
  if (count >= period) return everything;
  const double minimum = job.options.method == HoughMethod::standard ? job.options.min_theta : 0;
  const double direction = arc_tangent(dy, dx) - job.options.gradient_window - minimum;
  auto first = static_cast<std::int32_t>(detail::round_even(direction / step)) % period;
  if (first < 0) first += period;
  return window_from(job, first, count);
}

/// Whether the gradient at a pixel fits a line's normal.
class DirectionTest {
 public:
  DirectionTest(GradientView gradients, double window, double cosine, double sine) noexcept
      : gradients_(gradients),
        always_(!(window > 0) || window >= pi / 2),
        cosine_(cosine),
        sine_(sine),
        limit_(always_ ? 0 : straightedge::sine(window)) {
    limit_ *= limit_;
  }

  bool operator()(std::int32_t x, std::int32_t y) const noexcept {
    if (always_) return true;
    const double dx = gradients_.dx.at(x, y);
    const double dy = gradients_.dy.at(x, y);
    // |sine of the angle between| = |cross product| / length.
    const double cross = dx * sine_ - dy * cosine_;
    return cross * cross <= limit_ * (dx * dx + dy * dy);
  }

 private:
  GradientView gradients_;
  bool always_;
  double cosine_;
  double sine_;
  double limit_;
};

}  // namespace straightedge::hough
