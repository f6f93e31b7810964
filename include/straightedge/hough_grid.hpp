// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {

/// The cells of an accumulator, from the image's size and the options' steps.
///
/// Standard and progressive: OpenCV 4.6's numbers of angles and distances; distances are counted from
/// the first pixel, and there are enough of them for both signs of the longest one possible. Randomized:
/// angles [0, pi), distances from the image's centre to both sides.
///
/// Limits, `too_large` beyond: image sides 32767, 2^22 angles or distances, 2^28 cells.
struct HoughGrid {
  Status status = Status::invalid_image;
  std::int32_t angles = 0;
  std::int32_t distances = 0;
  std::int32_t half_turn = 0;  ///< angles in pi
  float rho_step = 0;          ///< as used: cut to float, as OpenCV does
  float theta_step = 0;
};

/// Cells outside [0, distances) into which rounding may put a vote, at each end of an angle's row.
inline constexpr std::int32_t hough_guard = 1;

namespace detail {

/// Nearest integer, halves to even, for |x| < 2^51: adding 1.5 * 2^52 leaves no bits for a fraction.
constexpr double round_even(double x) noexcept {
  return (x + 6755399441055744.0) - 6755399441055744.0;
}

constexpr bool within(double x, double low, double high) noexcept {
  return x >= low && x <= high;
}

constexpr bool valid_options(const HoughOptions& o) noexcept {
  const bool common = within(o.rho_step, 1e-3, 1e5) && within(o.theta_step, 1e-5, pi) && o.threshold >= 1 &&
                      within(o.min_length, 0, 1e9) && within(o.max_gap, 0, 1e9) &&
                      within(o.half_width, 0.5, 100) && within(o.min_support, 0, 1) &&
                      within(o.gradient_window, 0, pi);
  const bool angles = within(o.min_theta, 0, pi) && within(o.max_theta, 0, pi) && o.min_theta < o.max_theta;
  const bool pairs = within(o.pair_radius, 0, 1e5) && within(o.pair_min_distance, 1, 1e5) &&
                     (o.pair_radius == 0 || o.pair_min_distance < o.pair_radius) && o.pair_threshold >= 1 &&
                     o.confidence > 0 && o.confidence < 1;
  const bool names = o.method <= HoughMethod::randomized && o.generator <= HoughGenerator::opencv;
  return common && angles && pairs && names;
}

}  // namespace detail

constexpr HoughGrid hough_grid(Size size, const HoughOptions& options) noexcept {
  HoughGrid grid;
  if (size.width < 1 || size.height < 1) return grid;
  if (!detail::valid_options(options)) {
    grid.status = Status::invalid_option;
    return grid;
  }
  grid.status = Status::too_large;
  if (size.width > 32767 || size.height > 32767) return grid;
  grid.rho_step = static_cast<float>(options.rho_step);
  grid.theta_step = static_cast<float>(options.theta_step);
  const auto theta_step = static_cast<double>(grid.theta_step);
  const bool standard = options.method == HoughMethod::standard;
  const double range = standard ? options.max_theta - options.min_theta : pi;
  grid.half_turn = static_cast<std::int32_t>(detail::round_even(pi / theta_step));
  grid.angles = static_cast<std::int32_t>(detail::round_even(range / theta_step));
  if (grid.angles < 1) {
    grid.status = Status::invalid_option;
    return grid;
  }
  // A step far beyond the image would leave no cell at all: one takes every pixel.
  const std::int32_t extent = size.width + size.height;
  const float count = static_cast<float>(2 * extent + 1) / grid.rho_step;
  double distances = detail::round_even(static_cast<double>(count));
  if (options.method == HoughMethod::randomized) {
    // Half the diagonal is below half the sum of the sides.
    distances = 2 * detail::round_even(extent / (2.0 * static_cast<double>(grid.rho_step)) + 0.5) + 1;
  }
  if (distances > (1 << 22) || grid.angles > (1 << 22) || distances * grid.angles > (1 << 28)) return grid;
  grid.distances = distances < 1 ? 1 : static_cast<std::int32_t>(distances);
  grid.status = Status::ok;
  return grid;
}

/// Angles in a window of gradient_window to each side of a direction, all of them at most.
constexpr std::int32_t hough_window_angles(const HoughGrid& grid, const HoughOptions& options) noexcept {
  const double steps = detail::round_even(2 * options.gradient_window / static_cast<double>(grid.theta_step));
  return steps < grid.half_turn ? static_cast<std::int32_t>(steps) + 1 : grid.half_turn;
}

}  // namespace straightedge
