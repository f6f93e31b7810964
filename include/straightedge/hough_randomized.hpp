// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_job.hpp"

namespace straightedge {

/// The randomized Hough transform: two pixels make a line, so a pair casts one vote instead of two
/// pixels casting hundreds. Votes of one line meet in a cell, votes of chance pairs are strewn about.
///
///   1. List the edge pixels square by square (side: pair_radius). Clear the accumulator, whose origin is
///      the image's centre.
///   2. Draw a pixel, each equally likely, and a second from its square and the eight round it. The draw
///      is void if the second lies farther than pair_radius or nearer than pair_min_distance, or
///      (with a gradient window) if the gradient of either does not fit the line through both.
///   3. The pair's line (theta, rho) gets one vote. Below pair_threshold votes go back to 2.
///   4. Verify: read the piece of line round the first pixel in the strip of half_width, fit a line to
///      its pixels (least squares, their principal axis), and again with that line. A piece shorter than
///      min_length or carried by less than min_support is none: the vote is taken back.
///   5. The line's pieces in the whole image (end_points.hpp) are results; their pixels are taken out. The
///      cell starts anew. The peak is the fitted line, its votes the cell's.
///   6. Stop when as many draws in a row as `draws_needed` says, for the pixels that are left, have
///      brought no line; or at max_draws (`confident` is false then).
///
/// How many draws. An unbroken line of length l has at least l / sqrt(2) pixels. With N pixels
/// left, at most M of them in a square and its neighbours, a = pair_min_distance and
/// b = min(pair_radius, l), a draw hits a pair on that line with probability
///
///   p >= ((l - a)^2 - (l - b)^2) / (2 N M)                                                    (1)
///
/// (the pixels of the line that lie between a and b ahead of each of its pixels, and behind). Rounding to
/// pixels turns a pair's direction by up to 1 / a, which at half the diagonal H from the centre also
/// moves its rho; the votes spread over about
///
///   c = (2 + 1 / (a theta_step)) (2 + H theta_step / rho_step)                                (2)
///
/// cells. The number of votes in the fullest cell after D draws has the mean m = D p / c, and by
/// Chernoff's bound it is below T = pair_threshold with a chance of less than 1 - confidence when
///
///   sqrt(m) >= (sqrt(2 k) + sqrt(2 k + 4 T)) / 2,  k = -ln(1 - confidence)                    (3)
///
/// The statement is about each one line; it counts in c on the spread being about even, and lines
/// shorter than 2 a are taken as long as 2 a in (1).
///
/// With pair_radius = 0 both pixels are drawn from the whole image: M = N, so that the number of draws
/// grows with the square of N. That is the original method, kept to see why the radius is there.
///
/// Time: draws, plus for each line found or refused the steps of its walk. Results depend on the seed,
/// not on the machine.
///
/// L. Xu, E. Oja, P. Kultanen, 1990, doi:10.1016/0167-8655(90)90042-Z.
bool run_randomized(HoughJob& job) noexcept;

/// What the number of draws depends on.
struct PairDrawing {
  double pixels = 0;  ///< N, left in the image
  double nearby = 0;  ///< M, the most in a square and its neighbours
  double length = 0;  ///< l, of the line not to be missed, pixels
};

/// Equation (1).
double pair_hit_probability(const PairDrawing& drawing, const HoughOptions& options) noexcept;

/// Equation (2).
double pair_vote_spread(Size size, const HoughOptions& options) noexcept;

/// D by the equations (1) to (3), at most 4e18; max_draws is not looked at.
std::uint64_t draws_needed(const PairDrawing& drawing, Size size, const HoughOptions& options) noexcept;

}  // namespace straightedge
