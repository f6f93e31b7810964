// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/gradient_view.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct EndPointOptions {
  double min_length = 30;      ///< pixels between the end pixels' centres, [0, 1e9]
  double max_gap = 10;         ///< pixels, [0, 1e9]
  double half_width = 1.5;     ///< pixels, [0.5, 100]
  double min_support = 0.5;    ///< share of a piece's steps that must be carried, [0, 1]
  double gradient_window = 0;  ///< radians, [0, pi]; 0 = directions are not looked at
};

struct EndPointResult {
  Status status = Status::ok;
  std::uint32_t segments = 0;  ///< written
};

/// A Hough transform finds lines without ends. This reads from the edge image where a line really is.
///
///   1. Step through the image along the line: a column a step where the line is flat, a row where it is
///      steep. A step is carried if an edge pixel lies within half_width of the line (and, with a
///      gradient window, has its direction within that of the line's normal).
///   2. Steps that are carried belong to one piece as long as no hole between them, measured along the
///      line, is longer than max_gap (by more than a thousandth of a pixel).
///   3. A piece ends at the edge pixels nearest to the line in its first and last carried step. It is a
///      result if they are at least min_length apart and min_support of its steps are carried (chance
///      pixels, bridged one by one, carry few).
///
/// Segments run from left to right, those of steep lines from top to bottom. `votes` is the line's,
/// `pixels` counts the edge pixels in the strip.
///
/// Time: steps times the strip's width. No memory. Bad input: invalid_image, size_mismatch,
/// invalid_option (a line that is not finite, too), too_large (sides above 32767), output_full; a line
/// outside the image gives an empty result.
EndPointResult end_points(GrayView edges, GradientView gradients, const HoughPeak& line,
                          const EndPointOptions& options, std::span<HoughSegment> segments) noexcept;

}  // namespace straightedge
