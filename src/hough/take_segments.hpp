// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "hough/strip_walk.hpp"
#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// The pixels that no segment has taken yet.
inline GrayView remaining(const HoughJob& job) noexcept {
  return {job.memory.mask.data(), job.edges.size()};
}

/// Writes the pieces of `line` that are long enough and takes their pixels out of the mask. `taken`
/// counts these pixels. False: output full or cancelled.
bool take_segments(HoughJob& job, const ExactLine& line, std::int32_t votes, std::uint32_t& taken) noexcept;

}  // namespace straightedge::hough
