// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/hough_job.hpp"

namespace straightedge {

/// The standard Hough transform: a line is where many pixels agree.
///
/// Through the pixel (x, y) goes, for every angle theta of the normal, one line, that of distance
/// rho = x cos theta + y sin theta. Each pixel votes for all of them; the pixels of one line meet in one
/// cell (theta, rho) of the accumulator.
///
///   1. Table: theta_n as a float that starts at min_theta and grows by theta_step; cosine and sine
///      of it over rho_step, as floats.
///   2. Vote: each edge pixel, each n (with a gradient window: each n in it): the cell
///      r = round(x cos_n + y sin_n) + (distances - 1) / 2 gets one vote, halves rounded to even.
///   3. Peaks: cells with more than `threshold` votes, more than the neighbours at the smaller rho and
///      the smaller theta, at least as many as the other two. Sorted by votes, then theta, then rho.
///   4. End points: for each peak in that order, the pieces of its line in the edge image
///      (end_points.hpp). The pixels of a piece that is kept are taken out, so that weaker copies of the
///      same line find nothing left.
///
/// Steps 1 to 3 without a window give what OpenCV 4.6's HoughLines gives, bit for bit. Like it,
/// rho = (r - (distances - 1) / 2.0) * rho_step is half a step off when `distances` is even (with
/// rho_step 1 it never is). Unlike it, a step beyond the image leaves one cell of distance, not none.
///
/// P. V. C. Hough, "Method and means for recognizing complex patterns", US patent 3069654, 1962.
/// R. O. Duda, P. E. Hart, 1972, doi:10.1145/361237.361242.
/// F. O'Gorman, M. B. Clowes, 1976, doi:10.1109/T-C.1976.1674627 (the window).
///
/// Time: edge pixels times angles, plus cells, plus for each peak its line's length. Theta steps wider
/// than half_width over half the image's side lose the line's far ends in step 4.

bool vote_standard(HoughJob& job) noexcept;        ///< steps 1 and 2
bool find_standard_peaks(HoughJob& job) noexcept;  ///< step 3; keeps the best when `peaks` is full
bool read_peak_segments(HoughJob& job) noexcept;   ///< step 4

}  // namespace straightedge
