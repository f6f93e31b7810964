// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/fit_piece.hpp"

#include "straightedge/trigonometry.hpp"

namespace straightedge::hough {
namespace {

/// From `start` in steps of `direction` (1 or -1) to the last carried step before a long hole. `missing`
/// steps lie empty before the start. Returns how many lie empty before the first carried one.
std::int32_t extend(GrayView edges, const StripWalk& walk, const DirectionTest& fits, double max_gap,
                    std::int32_t start, std::int32_t direction, std::int32_t missing, Piece& piece) noexcept {
  std::int32_t before_first = missing;
  bool carried = false;
  for (std::int32_t step = start; step >= 0 && step < walk.steps(); step += direction) {
    const Support support = support_at(edges, walk, fits, step);
    if (support.pixels == 0) {
      ++missing;
      before_first += carried ? 0 : 1;
      if (too_long_a_gap(walk, missing, max_gap)) break;
      continue;
    }
    missing = 0;
    carried = true;
    if (piece.pixels == 0 || step < piece.first_step) {
      piece.first_step = step;
      piece.first_across = support.across;
    }
    if (piece.pixels == 0 || step > piece.last_step) {
      piece.last_step = step;
      piece.last_across = support.across;
    }
    ++piece.carried;
    piece.pixels += support.pixels;
  }
  return before_first;
}

}  // namespace

Piece piece_around(GrayView edges, const StripWalk& walk, const DirectionTest& fits, double max_gap,
                   std::int32_t start) noexcept {
  Piece piece;
  const std::int32_t missing = extend(edges, walk, fits, max_gap, start, 1, 0, piece);
  extend(edges, walk, fits, max_gap, start - 1, -1, missing, piece);
  return piece;
}

ExactLine fit_piece(GrayView edges, const StripWalk& walk, const DirectionTest& fits,
                    const Piece& piece) noexcept {
  // Sums of integers relative to one end: exact, so no order of adding matters.
  const std::int32_t x0 = walk.x(piece.first_step, piece.first_across);
  const std::int32_t y0 = walk.y(piece.first_step, piece.first_across);
  std::int64_t n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::int32_t step = piece.first_step; step <= piece.last_step; ++step) {
    const std::int32_t high = walk.high(step);
    for (std::int32_t across = walk.low(step); across <= high; ++across) {
      const std::int32_t x = walk.x(step, across);
      const std::int32_t y = walk.y(step, across);
      if (edges.at(x, y) == 0 || !fits(x, y)) continue;
      const std::int64_t dx = x - x0;
      const std::int64_t dy = y - y0;
      ++n;
      sx += dx;
      sy += dy;
      sxx += dx * dx;
      sxy += dx * dy;
      syy += dy * dy;
    }
  }
  const auto count = static_cast<double>(n);
  const double mean_x = static_cast<double>(sx) / count;
  const double mean_y = static_cast<double>(sy) / count;
  const double xx = static_cast<double>(sxx) - mean_x * static_cast<double>(sx);
  const double xy = static_cast<double>(sxy) - mean_x * static_cast<double>(sy);
  const double yy = static_cast<double>(syy) - mean_y * static_cast<double>(sy);
  // The normal lies across the principal axis, whose angle is half of that of (xx - yy, 2 xy).
  const SineCosine normal = sine_cosine(arc_tangent(2 * xy, xx - yy) / 2 + pi / 2);
  return {normal.cosine, normal.sine, (x0 + mean_x) * normal.cosine + (y0 + mean_y) * normal.sine};
}

}  // namespace straightedge::hough
