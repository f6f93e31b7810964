// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "localize/pieces.hpp"
#include "localize/scan_points.hpp"
#include "straightedge/random.hpp"
#include "straightedge/ransac_stop.hpp"

namespace straightedge::localize {
namespace {

constexpr std::uint32_t reach = 40;        // points along the row to the second of a pair
constexpr std::uint32_t most_draws = 400;  // for one line
constexpr double confidence = 0.99;

struct Found {
  std::uint32_t first = 0, last = 0;  // of the piece, in the list of free points
  std::uint32_t points = 0;
};

/// The line through two points, as a fit without covariance.
bool line_through(const ScanPoint& a, const ScanPoint& b, LineFit& fit) {
  LineMoments moments;
  moments.add(0, 0);
  moments.add(b.x_m - a.x_m, b.y_m - a.y_m);
  if (fit_line(moments, fit) != Status::ok) return false;
  fit.centroid_x += a.x_m;
  fit.centroid_y += a.y_m;
  return true;
}

/// Step b. The piece round number `seed` of the free points.
Found piece_round(const PointRow& row, const std::vector<std::uint32_t>& free, const LineFit& fit,
                  std::uint32_t seed) {
  Found found{seed, seed, 1};
  const auto walk = [&](std::int64_t step, std::uint32_t& end) {
    std::uint32_t last = seed;
    for (std::int64_t i = seed + step; i >= 0 && i < static_cast<std::int64_t>(free.size()); i += step) {
      const ScanPoint& p = row.points[free[static_cast<std::size_t>(i)]];
      const ScanPoint& before = row.points[free[last]];
      const double limit = allowed_gap(before, p, row.options, row.angle_step_rad);
      const bool on = std::fabs(fit.distance(p.x_m, p.y_m)) <= row.options.split_distance_m;
      const double dx = p.x_m - before.x_m, dy = p.y_m - before.y_m;
      const double gap = dx * dx + dy * dy;
      if (!on) continue;
      if (gap > limit * limit) break;
      last = static_cast<std::uint32_t>(i);
      ++found.points;
    }
    end = last;
  };
  walk(1, found.last);
  walk(-1, found.first);
  return found;
}

void collect(const PointRow& row, const std::vector<std::uint32_t>& free, const LineFit& fit,
             const Found& found, Pieces& pieces) {
  for (std::uint32_t i = found.first; i <= found.last; ++i) {
    const ScanPoint& p = row.points[free[i]];
    if (std::fabs(fit.distance(p.x_m, p.y_m)) <= row.options.split_distance_m) pieces.add(free[i]);
  }
}

/// How often a pair is of one piece: the first point is, and so is one of its neighbours.
double pair_probability(std::uint32_t piece, std::size_t all) {
  const double first = piece / static_cast<double>(all);
  return first * std::min(1.0, piece / (2.0 * reach));
}

/// Steps a and b, as often as needed. The best line's seed pair is in `best_fit`.
Found best_piece(const PointRow& row, const std::vector<std::uint32_t>& free, std::uint64_t& stream,
                 LineFit& best_fit) {
  Found best;
  std::uint32_t needed = most_draws;
  for (std::uint32_t draw = 0; draw < needed; ++draw) {
    Pcg32 random(row.options.seed, stream++);
    const auto count = static_cast<std::uint32_t>(free.size());
    const std::uint32_t a = random.below(count);
    const std::uint32_t low = a > reach ? a - reach : 0;
    const std::uint32_t b = low + random.below(std::min(count, a + reach + 1) - low);
    LineFit fit;
    if (a == b || !line_through(row.points[free[a]], row.points[free[b]], fit)) continue;
    const Found found = piece_round(row, free, fit, a);
    if (found.points <= best.points) continue;
    best = found;
    best_fit = fit;
    needed = draws_needed(pair_probability(best.points, free.size()), confidence, most_draws);
  }
  return best;
}

}  // namespace

void ransac_pieces(const PointRow& row, Pieces& pieces) {
  std::vector<std::uint32_t> free(row.points.size());
  for (std::uint32_t i = 0; i < free.size(); ++i) free[i] = i;
  std::uint64_t stream = 0;
  while (free.size() >= row.options.min_points) {
    LineFit fit;
    const Found found = best_piece(row, free, stream, fit);
    if (found.points < row.options.min_points) return;
    collect(row, free, fit, found, pieces);
    // Step c. The pair's line is only roughly the piece's.
    if (fit_points(row.points, pieces.open(), row.laser, row.options, fit)) {
      pieces.forget();
      collect(row, free, fit, found, pieces);
    }
    if (pieces.open().size() < row.options.min_points) {
      pieces.forget();
      return;
    }
    const std::span<const std::uint32_t> taken = pieces.open();
    std::erase_if(free, [&](std::uint32_t i) { return std::binary_search(taken.begin(), taken.end(), i); });
    pieces.close();
  }
}

}  // namespace straightedge::localize
