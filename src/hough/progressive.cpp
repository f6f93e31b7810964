// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_progressive.hpp"

#include <cstring>

#include "hough/angle_table.hpp"
#include "hough/cells.hpp"
#include "hough/compact_rows.hpp"
#include "hough/fixed_walk.hpp"
#include "hough/gradient_window.hpp"
#include "hough/opencv_generator.hpp"
#include "straightedge/random.hpp"

namespace straightedge {
namespace {

using hough::AngleWindow;
using hough::Candidate;
using hough::FixedWalk;

/// How far the walk got to one side.
struct WalkEnd {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

PixelStates states(const HoughJob& job) noexcept {
  return {job.memory.mask.data(), job.edges.width};
}

/// Most pixels are no edges: four at a time are read as one number, which need not be aligned.
bool any_edge(const std::uint8_t* four) noexcept {
  std::uint32_t all = 0;
  std::memcpy(&all, four, sizeof all);
  return all != 0;
}

/// Counts the edge pixels, and lists those for which there is room.
std::uint32_t list_pixels(HoughJob& job) noexcept {
  const PixelStates all = states(job);
  std::uint32_t count = 0;
  for (std::uint8_t& four : job.memory.mask) four = 0;
  for (std::int32_t y = 0; y < job.edges.height; ++y) {
    const std::uint8_t* row = job.edges.row(y);
    for (std::int32_t x = 0; x < job.edges.width; ++x) {
      while (x + 4 <= job.edges.width && !any_edge(row + x)) x += 4;
      if (x == job.edges.width) break;
      if (row[x] == 0) continue;
      all.set(x, y, PixelState::waiting);
      if (count < job.memory.points.size())
        job.memory.points[count] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
      ++count;
    }
  }
  return count;
}

Candidate vote_in_window(HoughJob& job, PixelPlace pixel) noexcept {
  const AngleWindow window = hough::angle_window(job, pixel.x, pixel.y);
  const Candidate none{job.options.threshold - 1, -1};
  const Candidate best = hough::cast_votes(job.memory, pixel, {window.first, window.end}, none);
  return hough::cast_votes(job.memory, pixel, {0, window.wrapped}, best);
}

WalkEnd find_end(const HoughJob& job, FixedWalk walk, PixelPlace start, std::int32_t max_gap) noexcept {
  const PixelStates all = states(job);
  WalkEnd end{start.x, start.y};
  std::int32_t gap = 0;
  for (; job.edges.contains(walk.x(), walk.y()); walk.advance()) {
    if (all.at(walk.x(), walk.y()) != PixelState::gone) {
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
  const PixelStates all = states(job);
  for (;; walk.advance()) {
    const std::int32_t x = walk.x();
    const std::int32_t y = walk.y();
    const PixelState state = all.at(x, y);
    if (state != PixelState::gone) {
      if (off(state)) {
        const PixelPlace pixel{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
        const AngleWindow window = hough::angle_window(job, x, y);
        hough::take_votes_off(job.memory, pixel, {window.first, window.end});
        hough::take_votes_off(job.memory, pixel, {0, window.wrapped});
      }
      all.set(x, y, PixelState::gone);
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
  // Holes are whole pixels.
  const auto max_gap =
      static_cast<std::int32_t>(as_opencv ? detail::round_even(job.options.max_gap) : job.options.max_gap);
  const auto n = static_cast<std::size_t>(candidate.angle);
  const FixedWalk ahead(pixel, -job.memory.sines[n], job.memory.cosines[n]);
  // Step 4.
  const WalkEnd first = find_end(job, ahead, pixel, max_gap);
  const WalkEnd second = find_end(job, ahead.turned(), pixel, max_gap);
  HoughSegment segment{first.x, first.y, second.x, second.y, candidate.votes, 0};
  const bool keep = long_enough(job, segment);
  // Step 5.
  const auto off = [as_opencv, keep](PixelState state) {
    return as_opencv ? keep : state == PixelState::voted;
  };
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
  hough::lay_out_rows(job);
  hough::clear_cells(job.memory);
  job.result.edge_pixels = list_pixels(job);
  if (job.result.edge_pixels > job.memory.points.size()) return job.stop(Status::too_large);

  const PixelStates all = states(job);
  Pcg32 pcg(job.options.seed);
  hough::OpencvGenerator opencv;
  for (std::uint32_t left = job.result.edge_pixels; left > 0; --left) {
    // Step 2.
    const std::uint32_t index =
        job.options.generator == HoughGenerator::opencv ? opencv.next() % left : pcg.below(left);
    const PixelPlace pixel = job.memory.points[index];
    job.memory.points[index] = job.memory.points[left - 1];
    ++job.result.draws;
    if (all.at(pixel.x, pixel.y) == PixelState::gone) continue;
    // Step 3.
    const Candidate candidate = vote_in_window(job, pixel);
    all.set(pixel.x, pixel.y, PixelState::voted);
    if (!job.tell({.step = HoughStep::vote, .x0 = pixel.x, .y0 = pixel.y, .votes = candidate.votes}))
      return false;
    if (candidate.angle >= 0 && !follow(job, pixel, candidate)) return false;
  }
  return true;
}

}  // namespace straightedge
