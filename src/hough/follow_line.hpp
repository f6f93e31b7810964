// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "hough/fixed_walk.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::hough {

inline PixelStates states(const HoughJob& job) noexcept {
  return {job.memory.mask.data(), job.edges.width};
}

/// How far the walk got to one side.
struct WalkEnd {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

inline WalkEnd find_end(const HoughJob& job, FixedWalk walk, PixelPlace start,
                        std::int32_t max_gap) noexcept {
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

/// Takes the pixels up to `end` out of the image. `take(pixel, state)` is called for each, before.
template <class Take>
bool take_pixels(HoughJob& job, FixedWalk walk, WalkEnd end, const Take& take,
                 std::int32_t& pixels) noexcept {
  const PixelStates all = states(job);
  for (;; walk.advance()) {
    const std::int32_t x = walk.x();
    const std::int32_t y = walk.y();
    const PixelState state = all.at(x, y);
    if (state != PixelState::gone) {
      take(PixelPlace{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)}, state);
      all.set(x, y, PixelState::gone);
      ++pixels;
      if (!job.tell({.step = HoughStep::removal, .x0 = x, .y0 = y})) return false;
    }
    if (x == end.x && y == end.y) return true;
  }
}

inline bool long_enough(const HoughJob& job, const HoughSegment& s) noexcept {
  const double dx = s.x1 < s.x0 ? s.x0 - s.x1 : s.x1 - s.x0;
  const double dy = s.y1 < s.y0 ? s.y0 - s.y1 : s.y1 - s.y0;
  if (job.options.generator == HoughGenerator::pcg32)
    return dx * dx + dy * dy >= job.options.min_length * job.options.min_length;
  return (dx > dy ? dx : dy) >= detail::round_even(job.options.min_length);
}

/// Steps 4 to 6 for one candidate: `take_off(pixel)` is called for each pixel whose votes come off.
template <class TakeOff>
bool follow_line(HoughJob& job, PixelPlace pixel, HoughCandidate candidate,
                 const TakeOff& take_off) noexcept {
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
  const auto take = [&](PixelPlace taken, PixelState state) {
    if (as_opencv ? keep : state == PixelState::voted) take_off(taken);
  };
  if (!take_pixels(job, ahead, first, take, segment.pixels)) return false;
  if (!take_pixels(job, ahead.turned(), second, take, segment.pixels)) return false;
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

}  // namespace straightedge::hough
