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
#include "hough/vote_in_windows.hpp"

namespace straightedge {
namespace {

using hough::AngleWindow;

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
  hough::Drawing drawing(job);
  while (drawing.left() > 0) {
    // Step 2.
    const PixelPlace pixel = drawing.next();
    ++job.result.draws;
    if (all.at(pixel.x, pixel.y) == PixelState::gone) continue;
    // Step 3.
    const HoughCandidate candidate = vote_in_window(job, pixel, hough::angle_window(job, pixel.x, pixel.y));
    all.set(pixel.x, pixel.y, PixelState::voted);
    if (!job.tell({.step = HoughStep::vote, .x0 = pixel.x, .y0 = pixel.y, .votes = candidate.votes}))
      return false;
    if (candidate.angle < 0) continue;
    const auto take_off = [&](PixelPlace taken) {
      take_off_in_window(job, taken, hough::angle_window(job, taken.x, taken.y));
    };
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
  if (hough::may_vote_in_windows(job)) return hough::vote_in_windows(job);
  return hough::may_vote_ahead(job) ? hough::vote_ahead(job) : vote_one_by_one(job);
}

}  // namespace straightedge
