// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/vote_bound.hpp"
#include "straightedge/hough_randomized.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge {
double pair_hit_probability(const PairDrawing& drawing, const HoughOptions& options) noexcept {
  const double a = options.pair_min_distance;
  const double length = drawing.length < 2 * a ? 2 * a : drawing.length;
  const bool anywhere = options.pair_radius == 0 || options.pair_radius > length;
  const double b = anywhere ? length : options.pair_radius;
  const double pairs = ((length - a) * (length - a) - (length - b) * (length - b)) / 2;
  const double all = drawing.pixels * drawing.nearby;
  return pairs < all ? pairs / all : 1;
}

double pair_vote_spread(Size size, const HoughOptions& options) noexcept {
  const double width = size.width;
  const double height = size.height;
  const double half_diagonal = square_root(width * width + height * height) / 2;
  return (2 + 1 / (options.pair_min_distance * options.theta_step)) *
         (2 + half_diagonal * options.theta_step / options.rho_step);
}

std::uint64_t draws_needed(const PairDrawing& drawing, Size size, const HoughOptions& options) noexcept {
  const double votes = hough::mean_votes_needed(options.confidence, options.pair_threshold);
  const double draws = votes * pair_vote_spread(size, options) / pair_hit_probability(drawing, options);
  if (draws >= 4e18) return std::uint64_t{4'000'000'000'000'000'000};
  return static_cast<std::uint64_t>(draws) + 1;
}

}  // namespace straightedge
