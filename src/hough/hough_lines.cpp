// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_lines.hpp"

#include "straightedge/hough_progressive.hpp"
#include "straightedge/hough_randomized.hpp"
#include "straightedge/hough_standard.hpp"

namespace straightedge {
namespace {

Status check_views(GrayView edges, GradientView gradients, Size size, bool windowed) noexcept {
  if (!edges.valid()) return Status::invalid_image;
  if (edges.size() != size) return Status::size_mismatch;
  if (!windowed) return Status::ok;
  if (!gradients.valid()) return Status::invalid_image;
  return gradients.dx.size() == size && gradients.dy.size() == size ? Status::ok : Status::size_mismatch;
}

void run_standard(HoughJob& job) noexcept {
  if (vote_standard(job) && find_standard_peaks(job)) read_peak_segments(job);
}

}  // namespace

Status HoughLines::prepare(HoughLines& lines, Size size, const HoughOptions& options,
                           std::span<std::byte> workspace) noexcept {
  lines = HoughLines{};
  const HoughGrid grid = hough_grid(size, options);
  if (grid.status != Status::ok) return grid.status;
  Arena arena(workspace);
  const HoughMemory memory = HoughMemory::take(arena, size, options, grid);
  if (arena.failed()) return Status::workspace_too_small;
  lines.size_ = size;
  lines.options_ = options;
  lines.grid_ = grid;
  lines.memory_ = memory;
  return Status::ok;
}

HoughResult HoughLines::run(GrayView edges, GradientView gradients, std::span<HoughPeak> peaks,
                            std::span<HoughSegment> segments, HoughTrace trace) noexcept {
  HoughJob job{edges, gradients, options_, grid_, memory_, peaks, segments, trace, {}};
  if (grid_.status != Status::ok) return job.result;
  job.result.seed = options_.seed;
  job.result.status = check_views(edges, gradients, size_, job.windowed());
  if (job.result.status != Status::ok) return job.result;
  switch (options_.method) {
    case HoughMethod::standard:
      run_standard(job);
      break;
    case HoughMethod::progressive:
      static_cast<void>(run_progressive(job));
      break;
    case HoughMethod::randomized:
      static_cast<void>(run_randomized(job));
      break;
  }
  return job.result;
}

}  // namespace straightedge
