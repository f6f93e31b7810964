// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// Whether there are kernels for pixels that vote in gradient windows, nobody watches, and cells are small.
bool may_vote_in_windows(const HoughJob& job) noexcept;

/// Steps 2 to 6 of the progressive method with a gradient window, with the results of one pixel after the
/// other.
///
///   a. Of the next pixels that are still there, all windows are found together. Most pixels are taken by a
///      line before they are drawn: theirs are never asked for.
///   b. They vote, one after the other, until one has a candidate.
///   c. Its line is followed. Whom it takes of those that come later in the batch does not vote.
///   d. Votes of a line's pixels come off together; their windows are found anew.
bool vote_in_windows(HoughJob& job) noexcept;

}  // namespace straightedge::hough
