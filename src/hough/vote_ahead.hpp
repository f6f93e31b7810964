// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// Whether pixels may vote before it is their turn: there are kernels for it, nobody watches, all pixels
/// vote for all angles, and no cell overflows from a batch too many.
bool may_vote_ahead(const HoughJob& job) noexcept;

/// Steps 2 to 6 of the progressive method, many pixels at a time, with the results of one after the other.
///
///   a. The next pixels that are still there vote together, angle by angle: one row of cells after the
///      other stays in the cache.
///   b. Then it is their turn, one by one. Cells can only have lost votes since: who saw fewer than
///      `threshold` votes when it voted has no candidate.
///   c. For the others the candidate is found anew, without the votes of those whose turn has not come and
///      of those that leave.
///   d. Who was taken by a line meanwhile leaves, as the line's pixels do.
///   e. Those that leave take their votes off together, before others vote.
bool vote_ahead(HoughJob& job) noexcept;

}  // namespace straightedge::hough
