// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/hough_job.hpp"

namespace straightedge {

/// The progressive probabilistic Hough transform: pixels vote in random order, and a line is taken as
/// soon as it stands out, together with its pixels, which then need not vote any more.
///
///   1. Table: cosine and sine of n * theta_step over rho_step, as floats; one row of cells after the other,
///      each as long as the distances that pixels of the image have at that angle. List all edge pixels;
///      more than there is room for: too_large.
///   2. Draw a pixel that has not been drawn; pass over those that a line has taken meanwhile.
///   3. It votes for all angles, or those in its gradient window. The first angle with the most votes
///      is the candidate; below `threshold` votes go back to 2.
///   4. Walk from the pixel along the candidate, both ways, one pixel wide, to the last edge pixel before
///      a hole longer than max_gap.
///   5. Walk again: take all pixels up to the two ends out of the image, and their votes off the
///      accumulator.
///   6. If the segment is long enough, it is a result, with the candidate's votes. Back to 2.
///
/// J. Matas, C. Galambos, J. Kittler, 2000, doi:10.1006/cviu.1999.0831.
/// F. O'Gorman, M. B. Clowes, 1976, doi:10.1109/T-C.1976.1674627 (the window).
///
/// Two generators, and with them two readings of steps 5 and 6:
///
///   pcg32   Numbers by `seed`, unbiased. Votes come off those pixels alone that have voted, exactly
///           those they cast, whether the segment is long enough or not. Length is Euclidean.
///   opencv  OpenCV 4.6's HoughLinesP, segment for segment in order: its fixed numbers; min_length
///           and max_gap rounded to integers; length is max(|dx|, |dy|); votes come off only for
///           segments that are long enough, but also for pixels that have not voted yet, so cells go
///           below zero. With a gradient window (which OpenCV lacks) each pixel's votes come off in
///           its own window.
///
/// Memory: the rows of all angles have about (2 / theta_step) (width + height) / rho_step cells. A cell
/// never holds more than `threshold` votes (hough_cells.hpp), so it is a byte when threshold is below 256;
/// where OpenCV is followed, two. Two bits a pixel, 4 bytes for each of max_edge_pixels. 320x240 with
/// steps of 1 px and 2 degrees and room for 8000 edge pixels: 86 KB; as OpenCV 119 KB.
///
/// With `kernels` many pixels are looked at together, with the same results: they vote at the same time
/// (src/hough/vote_ahead.hpp), or find their gradient windows (src/hough/vote_in_windows.hpp); 5 KB more. Not when
/// a trace watches.
///
/// Time: pixels that vote times angles in the window, plus the walks. The segment's first end lies
/// ahead of the pixel drawn, along (-sin theta, cos theta), the second behind it.
bool run_progressive(HoughJob& job) noexcept;

}  // namespace straightedge
