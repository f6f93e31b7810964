// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "hough/strip_walk.hpp"
#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// The piece of `walk`'s line that goes through step `start`, by the rules of end_points.hpp. No pixels:
/// there is none.
Piece piece_around(GrayView edges, const StripWalk& walk, const DirectionTest& fits, double max_gap,
                   std::int32_t start) noexcept;

/// The line with the least sum of squared distances to the piece's pixels: through their mean, along
/// the principal axis of their second moments.
ExactLine fit_piece(GrayView edges, const StripWalk& walk, const DirectionTest& fits,
                    const Piece& piece) noexcept;

}  // namespace straightedge::hough
