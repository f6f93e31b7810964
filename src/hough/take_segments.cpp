// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/take_segments.hpp"

namespace straightedge::hough {
namespace {

bool take_pixels(HoughJob& job, const StripWalk& walk, const DirectionTest& fits, const Piece& piece,
                 std::uint32_t& taken) noexcept {
  const ImageView<std::uint8_t> mask(job.memory.mask.data(), job.edges.size());
  for (std::int32_t step = piece.first_step; step <= piece.last_step; ++step) {
    const std::int32_t high = walk.high(step);
    for (std::int32_t across = walk.low(step); across <= high; ++across) {
      const std::int32_t x = walk.x(step, across);
      const std::int32_t y = walk.y(step, across);
      if (mask.at(x, y) == 0 || !fits(x, y)) continue;
      mask.at(x, y) = 0;
      ++taken;
      if (!job.tell({.step = HoughStep::removal, .x0 = x, .y0 = y})) return false;
    }
  }
  return true;
}

}  // namespace

bool take_segments(HoughJob& job, const ExactLine& line, std::int32_t votes, std::uint32_t& taken) noexcept {
  const StripWalk walk(job.edges.size(), line, job.options.half_width);
  const DirectionTest fits(job.gradients, job.options.gradient_window, line.cosine, line.sine);
  return for_each_piece(remaining(job), walk, fits, job.options.max_gap, [&](const Piece& piece) {
    if (!worth_keeping(piece, job.options.min_length, job.options.min_support)) return true;
    return (job.segments.empty() || job.write(segment_of(walk, piece, votes))) &&
           take_pixels(job, walk, fits, piece, taken);
  });
}

}  // namespace straightedge::hough
