// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_progressive.hpp"

#include "hough/angle_table.hpp"
#include "hough/fixed_walk.hpp"
#include "hough/gradient_window.hpp"
#include "hough/opencv_generator.hpp"
#include "straightedge/random.hpp"

namespace straightedge {
namespace {

using hough::AngleWindow;
using hough::FixedWalk;

enum PixelState : std::uint8_t { gone = 0, waiting = 1, voted = 2 };

struct Candidate {
  std::int32_t votes = 0;
  std::int32_t angle = -1;  ///< negative: no angle has enough votes
};

/// How far the walk got to one side.
struct WalkEnd {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

std::uint8_t& state(HoughJob& job, std::int32_t x, std::int32_t y) noexcept {
  const auto width = static_cast<std::size_t>(job.edges.width);
  return job.memory.mask[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
}

std::uint32_t list_pixels(HoughJob& job) noexcept {
  std::uint32_t count = 0;
  for (std::int32_t y = 0; y < job.edges.height; ++y) {
    const std::uint8_t* row = job.edges.row(y);
    for (std::int32_t x = 0; x < job.edges.width; ++x) {
      state(job, x, y) = row[x] != 0 ? waiting : gone;
      if (row[x] == 0) continue;
      job.memory.points[count++] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    }
  }
  return count;
}

/// Adds `weight` to the cells of pixel (x, y) at angles [first, end). Returns the first angle whose cell
/// exceeds `best`, and raises `best` to it.
void vote(HoughJob& job, std::int32_t x, std::int32_t y, std::int32_t first, std::int32_t end,
          Candidate& best) noexcept {
  const auto u = static_cast<float>(x);
  const auto v = static_cast<float>(y);
  std::int32_t* row = job.memory.cells.data() + hough_guard + (job.grid.distances - 1) / 2 +
                      static_cast<std::ptrdiff_t>(first) * job.grid.distances;
  for (std::int32_t n = first; n < end; ++n, row += job.grid.distances) {
    const std::int32_t votes = ++row[hough::distance_cell(job.memory, static_cast<std::size_t>(n), u, v)];
    if (votes > best.votes) best = {votes, n};
  }
}

void take_votes_off(HoughJob& job, std::int32_t x, std::int32_t y, std::int32_t first,
                    std::int32_t end) noexcept {
  const auto u = static_cast<float>(x);
  const auto v = static_cast<float>(y);
  std::int32_t* row = job.memory.cells.data() + hough_guard + (job.grid.distances - 1) / 2 +
                      static_cast<std::ptrdiff_t>(first) * job.grid.distances;
  for (std::int32_t n = first; n < end; ++n, row += job.grid.distances)
    --row[hough::distance_cell(job.memory, static_cast<std::size_t>(n), u, v)];
}

Candidate vote_in_window(HoughJob& job, PixelPlace pixel) noexcept {
  Candidate best{job.options.threshold - 1, -1};
  const AngleWindow window = hough::angle_window(job, pixel.x, pixel.y);
  vote(job, pixel.x, pixel.y, window.first, window.end, best);
  vote(job, pixel.x, pixel.y, 0, window.wrapped, best);
  return best;
}

WalkEnd find_end(HoughJob& job, FixedWalk walk, PixelPlace start, double max_gap) noexcept {
  WalkEnd end{start.x, start.y};
  std::int32_t gap = 0;
  for (; job.edges.contains(walk.x(), walk.y()); walk.advance()) {
    if (state(job, walk.x(), walk.y()) != gone) {
      gap = 0;
      end = {walk.x(), walk.y()};
    } else if (++gap > max_gap) {
      break;
    }
  }
  return end;
}

/// Takes the pixels up to `end` out of the image, and their votes off if `off` says so.
template <class TakeOff>
bool take_pixels(HoughJob& job, FixedWalk walk, WalkEnd end, TakeOff off, std::int32_t& pixels) noexcept {
  for (;; walk.advance()) {
    const std::int32_t x = walk.x();
    const std::int32_t y = walk.y();
    std::uint8_t& mark = state(job, x, y);
    if (mark != gone) {
      if (off(mark)) {
        const AngleWindow window = hough::angle_window(job, x, y);
        take_votes_off(job, x, y, window.first, window.end);
        take_votes_off(job, x, y, 0, window.wrapped);
      }
      mark = gone;
      ++pixels;
      if (!job.tell({.step = HoughStep::removal, .x0 = x, .y0 = y})) return false;
    }
    if (x == end.x && y == end.y) return true;
  }
}

bool long_enough(const HoughJob& job, const HoughSegment& s) noexcept {
  const double dx = s.x1 < s.x0 ? s.x0 - s.x1 : s.x1 - s.x0;
  const double dy = s.y1 < s.y0 ? s.y0 - s.y1 : s.y1 - s.y0;
  if (job.options.generator == HoughGenerator::pcg32)
    return dx * dx + dy * dy >= job.options.min_length * job.options.min_length;
  return (dx > dy ? dx : dy) >= detail::round_even(job.options.min_length);
}

/// Steps 4 to 6 for one candidate.
bool follow(HoughJob& job, PixelPlace pixel, Candidate candidate) noexcept {
  const bool as_opencv = job.options.generator == HoughGenerator::opencv;
  const double max_gap = as_opencv ? detail::round_even(job.options.max_gap) : job.options.max_gap;
  const auto n = static_cast<std::size_t>(candidate.angle);
  const FixedWalk ahead(pixel, -job.memory.sines[n], job.memory.cosines[n]);
  // Step 4.
  const WalkEnd first = find_end(job, ahead, pixel, max_gap);
  const WalkEnd second = find_end(job, ahead.turned(), pixel, max_gap);
  HoughSegment segment{first.x, first.y, second.x, second.y, candidate.votes, 0};
  const bool keep = long_enough(job, segment);
  // Step 5.
  const auto off = [as_opencv, keep](std::uint8_t mark) { return as_opencv ? keep : mark == voted; };
  if (!take_pixels(job, ahead, first, off, segment.pixels)) return false;
  if (!take_pixels(job, ahead.turned(), second, off, segment.pixels)) return false;
  // Step 6.
  if (!keep) return true;
  return job.write(segment) && job.tell({.step = HoughStep::line,
                                         .x0 = segment.x0,
                                         .y0 = segment.y0,
                                         .x1 = segment.x1,
                                         .y1 = segment.y1,
                                         .theta = static_cast<float>(n) * job.grid.theta_step,
                                         .votes = segment.votes});
}

}  // namespace

bool run_progressive(HoughJob& job) noexcept {
  // Step 1.
  hough::fill_angles_by_multiplying(job);
  for (std::int32_t& cell : job.memory.cells) cell = 0;
  job.result.edge_pixels = list_pixels(job);

  Pcg32 pcg(job.options.seed);
  hough::OpencvGenerator opencv;
  for (std::uint32_t left = job.result.edge_pixels; left > 0; --left) {
    // Step 2.
    const std::uint32_t index =
        job.options.generator == HoughGenerator::opencv ? opencv.next() % left : pcg.below(left);
    const PixelPlace pixel = job.memory.points[index];
    job.memory.points[index] = job.memory.points[left - 1];
    ++job.result.draws;
    if (state(job, pixel.x, pixel.y) == gone) continue;
    // Step 3.
    const Candidate candidate = vote_in_window(job, pixel);
    state(job, pixel.x, pixel.y) = voted;
    if (!job.tell({.step = HoughStep::vote, .x0 = pixel.x, .y0 = pixel.y, .votes = candidate.votes}))
      return false;
    if (candidate.angle >= 0 && !follow(job, pixel, candidate)) return false;
  }
  return true;
}

}  // namespace straightedge
