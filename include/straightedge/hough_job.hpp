// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "straightedge/gradient_view.hpp"
#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_memory.hpp"
#include "straightedge/hough_options.hpp"

namespace straightedge {

/// All that a stage of one run reads and writes, for those who call the stages one by one; HoughLines
/// fills it, checks it and calls them in turn. Stages do not check their views again. A stage that
/// returns false has put the reason (`output_full`, `cancelled`) into `result.status`.
struct HoughJob {
  GrayView edges;
  GradientView gradients;  ///< looked at only when options.gradient_window > 0
  HoughOptions options;
  HoughGrid grid;
  HoughMemory memory;
  std::span<HoughPeak> peaks;
  std::span<HoughSegment> segments;
  HoughTrace trace;
  HoughResult result;

  bool windowed() const noexcept { return options.gradient_window > 0; }

  bool stop(Status why) noexcept {
    result.status = why;
    return false;
  }

  /// Tells the trace; false when it wants to stop.
  bool tell(const HoughEvent& event) noexcept { return trace(event) || stop(Status::cancelled); }

  bool write(const HoughSegment& segment) noexcept {
    if (result.segments == segments.size()) return stop(Status::output_full);
    segments[result.segments++] = segment;
    return true;
  }
};

}  // namespace straightedge
