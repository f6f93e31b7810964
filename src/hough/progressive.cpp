// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_progressive.hpp"

#include "hough/angle_table.hpp"
#include "hough/cells.hpp"
#include "hough/compact_rows.hpp"
#include "hough/drawing.hpp"
#include "hough/follow_line.hpp"
#include "hough/gradient_window.hpp"
#include "hough/list_pixels.hpp"
#include "hough/vote_ahead.hpp"

namespace straightedge {
namespace {

using hough::AngleWindow;

/// The angles that pixels vote for, from the gradients or as they were noted when the pixels were listed.
class Windows {
 public:
  explicit Windows(const HoughJob& job) noexcept : job_(job), count_(hough::window_angles(job)) {}

  AngleWindow of(PixelPlace pixel) const noexcept {
    if (job_.memory.firsts.empty()) return hough::angle_window(job_, pixel.x, pixel.y);
    const auto width = static_cast<std::size_t>(job_.edges.width);
    const std::uint16_t first = job_.memory.firsts[pixel.y * width + pixel.x];
    if (first == hough_no_direction || count_ >= job_.grid.half_turn) return {0, job_.grid.angles, 0};
    return hough::window_from(job_, first, count_);
  }

 private:
  const HoughJob& job_;
  std::int32_t count_;
};

HoughCandidate vote_in_window(HoughJob& job, PixelPlace pixel, const AngleWindow& window) noexcept {
  const HoughCandidate none{job.options.threshold - 1, -1};
  const HoughCandidate best = hough::cast_votes(job.memory, pixel, {window.first, window.end}, none);
  return hough::cast_votes(job.memory, pixel, {0, window.wrapped}, best);
}

void take_off_in_window(HoughJob& job, PixelPlace pixel, const AngleWindow& window) noexcept {
  hough::take_votes_off(job.memory, pixel, {window.first, window.end});
  hough::take_votes_off(job.memory, pixel, {0, window.wrapped});
}

/// Steps 2 to 6, one pixel after the other.
bool vote_one_by_one(HoughJob& job) noexcept {
  const PixelStates all = hough::states(job);
  const Windows windows(job);
  hough::Drawing drawing(job);
  while (drawing.left() > 0) {
    // Step 2.
    const PixelPlace pixel = drawing.next();
    ++job.result.draws;
    if (all.at(pixel.x, pixel.y) == PixelState::gone) continue;
    // Step 3.
    const HoughCandidate candidate = vote_in_window(job, pixel, windows.of(pixel));
    all.set(pixel.x, pixel.y, PixelState::voted);
    if (!job.tell({.step = HoughStep::vote, .x0 = pixel.x, .y0 = pixel.y, .votes = candidate.votes}))
      return false;
    if (candidate.angle < 0) continue;
    const auto take_off = [&](PixelPlace taken) { take_off_in_window(job, taken, windows.of(taken)); };
    if (!hough::follow_line(job, pixel, candidate, take_off)) return false;
  }
  return true;
}

}  // namespace

bool run_progressive(HoughJob& job) noexcept {
  // Step 1.
  hough::fill_angles_by_multiplying(job);
  hough::lay_out_rows(job);
  hough::clear_cells(job.memory);
  job.result.edge_pixels = hough::list_pixels(job);
  if (job.result.edge_pixels > job.memory.points.size()) return job.stop(Status::too_large);
  return hough::may_vote_ahead(job) ? hough::vote_ahead(job) : vote_one_by_one(job);
}

}  // namespace straightedge
