// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_randomized.hpp"

#include "hough/cells.hpp"
#include "hough/fit_piece.hpp"
#include "hough/gradient_window.hpp"
#include "hough/pixel_buckets.hpp"
#include "hough/strip_walk.hpp"
#include "hough/take_segments.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

using hough::DirectionTest;
using hough::ExactLine;
using hough::Piece;
using hough::PixelBuckets;
using hough::StripWalk;

struct Pair {
  PixelPlace first;
  PixelPlace second;
};

/// The line through a pair, and the angle of its normal in [0, pi].
struct PairLine {
  ExactLine line;
  double theta = 0;
};

bool in_mask(const HoughJob& job, PixelPlace p) noexcept {
  return job.memory.mask[p.y * static_cast<std::size_t>(job.edges.width) + p.x] != 0;
}

/// The same line with its normal's angle in [0, pi).
double upper_angle(ExactLine& line) noexcept {
  double theta = arc_tangent(line.sine, line.cosine);
  if (theta < 0 || theta >= pi) {
    line = {-line.cosine, -line.sine, -line.rho};
    theta += theta < 0 ? pi : -pi;
  }
  return theta;
}

/// Step 2. False: the draw is void.
bool draw_pair(const HoughJob& job, const PixelBuckets& buckets, Pcg32& random, Pair& pair) noexcept {
  do {
    pair.first = buckets.draw(random);
  } while (!in_mask(job, pair.first));
  pair.second = buckets.draw_near(pair.first, random);
  if (!in_mask(job, pair.second)) return false;
  const double dx = pair.second.x - pair.first.x;
  const double dy = pair.second.y - pair.first.y;
  const double squared = dx * dx + dy * dy;
  const double radius = job.options.pair_radius;
  return squared >= job.options.pair_min_distance * job.options.pair_min_distance &&
         (radius == 0 || squared <= radius * radius);
}

PairLine line_through(const Pair& pair) noexcept {
  const double dx = pair.second.x - pair.first.x;
  const double dy = pair.second.y - pair.first.y;
  PairLine result;
  result.theta = arc_tangent(dx, -dy);
  if (result.theta < 0) result.theta += pi;
  const SineCosine normal = sine_cosine(result.theta);
  result.line = {normal.cosine, normal.sine, pair.first.x * normal.cosine + pair.first.y * normal.sine};
  return result;
}

bool directions_fit(const HoughJob& job, const Pair& pair, const ExactLine& line) noexcept {
  const DirectionTest fits(job.gradients, job.options.gradient_window, line.cosine, line.sine);
  return fits(pair.first.x, pair.first.y) && fits(pair.second.x, pair.second.y);
}

/// Step 3's cell. The line theta = pi is that of theta = 0 with the other sign of rho.
std::size_t cell_of(const HoughJob& job, const PairLine& pair) noexcept {
  const double centre_x = (job.edges.width - 1) / 2.0;
  const double centre_y = (job.edges.height - 1) / 2.0;
  double rho = pair.line.rho - centre_x * pair.line.cosine - centre_y * pair.line.sine;
  auto n =
      static_cast<std::int32_t>(detail::round_even(pair.theta / static_cast<double>(job.grid.theta_step)));
  if (n >= job.grid.angles) {
    n = 0;
    rho = -rho;
  }
  const auto r = static_cast<std::int32_t>(detail::round_even(rho / static_cast<double>(job.grid.rho_step))) +
                 (job.grid.distances - 1) / 2;
  return static_cast<std::size_t>(hough_guard) +
         static_cast<std::size_t>(n) * static_cast<std::size_t>(job.grid.distances) +
         static_cast<std::size_t>(r);
}

/// Adds to a cell and returns its votes.
std::int32_t add_votes(const HoughJob& job, std::size_t index, std::int32_t votes) noexcept {
  return hough::with_cells(job.memory, [=]<class Cell>(Cell* cells) noexcept {
    cells[index] = static_cast<Cell>(cells[index] + votes);
    return std::int32_t{cells[index]};
  });
}

/// Step 4. False: there is no line of min_length here.
bool verify(const HoughJob& job, PixelPlace at, ExactLine& line) noexcept {
  const GrayView edges = hough::remaining(job);
  for (int pass = 0;; ++pass) {
    const StripWalk walk(edges.size(), line, job.options.half_width);
    const DirectionTest fits(job.gradients, job.options.gradient_window, line.cosine, line.sine);
    const Piece piece = hough::piece_around(edges, walk, fits, job.options.max_gap, walk.step_of(at.x, at.y));
    // The pair's own line may leave a good piece early: half the length is enough to go on.
    const double enough = pass == 0 ? job.options.min_length / 2 : job.options.min_length;
    if (piece.pixels < 2 || !hough::worth_keeping(piece, enough, job.options.min_support)) return false;
    if (pass == 2) return true;
    line = hough::fit_piece(edges, walk, fits, piece);
  }
}

/// Step 5.
bool take_line(HoughJob& job, ExactLine line, std::int32_t votes, std::uint32_t& taken) noexcept {
  const double theta = upper_angle(line);
  const HoughPeak peak{static_cast<float>(line.rho), static_cast<float>(theta), votes};
  if (!job.peaks.empty()) {
    if (job.result.peaks == job.peaks.size()) return job.stop(Status::output_full);
    job.peaks[job.result.peaks++] = peak;
  }
  return job.tell({.step = HoughStep::line, .rho = peak.rho, .theta = peak.theta, .votes = votes}) &&
         hough::take_segments(job, line, votes, taken);
}

std::uint64_t most_draws(const HoughJob& job) noexcept {
  if (job.options.max_draws > 0) return job.options.max_draws;
  const std::uint64_t by_pixels = std::uint64_t{8} * job.result.edge_pixels;
  return by_pixels > 1'000'000 ? by_pixels : 1'000'000;
}

std::uint64_t patience(const HoughJob& job, const PixelBuckets& buckets, std::uint32_t left) noexcept {
  const PairDrawing drawing{static_cast<double>(left), static_cast<double>(buckets.most_nearby()),
                            job.options.min_length};
  return draws_needed(drawing, job.edges.size(), job.options);
}

/// Steps 2 to 5 for one draw; `taken` counts the pixels that left.
bool one_draw(HoughJob& job, const PixelBuckets& buckets, Pcg32& random, std::uint32_t& taken) noexcept {
  // Step 2.
  Pair pair;
  if (!draw_pair(job, buckets, random, pair)) return true;
  const PairLine through = line_through(pair);
  if (!directions_fit(job, pair, through.line)) return true;
  // Step 3.
  const std::size_t cell = cell_of(job, through);
  const std::int32_t votes = add_votes(job, cell, 1);
  if (!job.tell({.step = HoughStep::vote,
                 .x0 = pair.first.x,
                 .y0 = pair.first.y,
                 .x1 = pair.second.x,
                 .y1 = pair.second.y,
                 .theta = static_cast<float>(through.theta),
                 .votes = votes}))
    return false;
  if (votes < job.options.pair_threshold) return true;
  // Step 4.
  ExactLine line = through.line;
  if (!verify(job, pair.first, line)) {
    add_votes(job, cell, -1);
    return true;
  }
  // Step 5.
  add_votes(job, cell, -votes);
  return take_line(job, line, votes, taken);
}

}  // namespace

bool run_randomized(HoughJob& job) noexcept {
  // Step 1.
  hough::clear_cells(job.memory);
  PixelBuckets buckets(job);
  Pcg32 random(job.options.seed);
  std::uint32_t left = buckets.size();
  job.result.edge_pixels = left;
  if (left > job.memory.points.size()) return job.stop(Status::too_large);

  const std::uint64_t most = most_draws(job);
  std::uint64_t fruitless = 0;
  std::uint64_t limit = left < 2 ? 0 : patience(job, buckets, left);
  while (left >= 2) {
    // Step 6.
    if (fruitless >= limit) break;
    if (job.result.draws == most) break;
    ++job.result.draws;
    ++fruitless;
    std::uint32_t taken = 0;
    if (!one_draw(job, buckets, random, taken)) return false;
    if (taken == 0) continue;
    fruitless = 0;
    left -= taken;
    // Few listed pixels are gone at any time, and compacting costs less than the lines that led to it.
    if (left < buckets.size() - buckets.size() / 8) buckets.compact(job);
    limit = patience(job, buckets, left < 2 ? 2 : left);
  }
  job.result.confident = left < 2 || fruitless >= limit;
  return true;
}

}  // namespace straightedge
