// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/gradient_view.hpp"
#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_memory.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/hough_views.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// Straight lines in an edge image by the Hough transform. Three methods behind one options struct;
/// each has its own manual:
///
///   standard     hough_standard.hpp     equal to OpenCV 4.6's HoughLines, plus end points
///   progressive  hough_progressive.hpp  equal to HoughLinesP with generator = opencv
///   randomized   hough_randomized.hpp   pairs of pixels, one vote each
///
/// Input: `edges`, an 8-bit image; every value but 0 is an edge pixel. `gradients` only when
/// `gradient_window` > 0: then a pixel supports a line only if its gradient lies within the window round
/// the line's normal, modulo pi (F. O'Gorman, M. B. Clowes, 1976, doi:10.1109/T-C.1976.1674627). A pixel
/// with null gradient has no direction and supports every line.
///
/// Output: `peaks` (standard, randomized) and `segments` in the order in which they are found. Standard
/// and randomized: an empty span means that this kind is not wanted, but the standard method reads the
/// end points of those lines alone that `peaks` holds. More than fits gives `output_full`: the
/// first segments, and of the standard peaks those with the most votes.
///
/// Memory:
///   standard     4 bytes a cell (hough_grid.hpp), 1 a pixel, 128 a column.
///   progressive  1 byte (2 or 4 where more votes can meet) for each cell that a line through the image can
///                have (hough_cells.hpp), a quarter of a byte a pixel, 4 for each edge pixel that there is
///                room for (max_edge_pixels).
///   randomized   1 byte a cell (2 or 4 with pair_threshold above 255), 1 a pixel, 4 for each edge pixel that
///                there is room for, and 4 for each 64 pixels at most.
///
/// Bad input: invalid_image (null views, no gradients where a window is asked for), size_mismatch,
/// invalid_option, workspace_too_small, not_prepared; too_large from `prepare` for the image's size, from
/// `run` for more than max_edge_pixels edge pixels: `edge_pixels` of the result tells how many, nothing else
/// is written, and the next run may have fewer. A blank image gives an empty result.
class HoughLines {
 public:
  /// Bytes that `prepare` needs; 0 when size or options are invalid or too large.
  static constexpr std::size_t workspace_bytes(Size size, const HoughOptions& options) noexcept {
    const HoughGrid grid = hough_grid(size, options);
    if (grid.status != Status::ok) return 0;
    Arena arena = Arena::measure();
    HoughMemory::take(arena, size, options, grid);
    return arena.failed() ? 0 : arena.used();
  }

  /// After a failure `lines` is not prepared.
  static Status prepare(HoughLines& lines, Size size, const HoughOptions& options,
                        std::span<std::byte> workspace) noexcept;

  HoughResult run(GrayView edges, GradientView gradients, std::span<HoughPeak> peaks,
                  std::span<HoughSegment> segments, HoughTrace trace = {}) noexcept;
  HoughResult run(GrayView edges, std::span<HoughPeak> peaks, std::span<HoughSegment> segments,
                  HoughTrace trace = {}) noexcept {
    return run(edges, GradientView{}, peaks, segments, trace);
  }

  const HoughGrid& grid() const noexcept { return grid_; }

  // What the last `run` left behind.

  /// Not valid before `prepare`.
  HoughVotesView accumulator() const noexcept {
    return grid_.status == Status::ok ? HoughVotesView(size_, options_.method, grid_, memory_)
                                      : HoughVotesView();
  }
  HoughRemainingView remaining() const noexcept { return {size_, options_.method, memory_}; }

 private:
  Size size_;
  HoughOptions options_;
  HoughGrid grid_;
  HoughMemory memory_;
};

}  // namespace straightedge
