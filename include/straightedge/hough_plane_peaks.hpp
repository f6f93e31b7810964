// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_accumulator.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// A cell that stands out, and its votes.
struct HoughPlanePeak {
  std::int32_t direction = 0;  ///< cell of the accumulator's directions
  std::int32_t distance = 0;   ///< cell of its distances
  std::uint32_t votes = 0;     ///< in the cell; after low_pass_votes, of the mean

  constexpr bool operator==(const HoughPlanePeak&) const noexcept = default;
};

/// Low-pass of the votes, so that a plane that lies on the border of cells is worth as much as one in the
/// middle of a cell.
///
///   1. Along the distance: 1 2 1.
///   2. Over the directions: the cell's own value plus the mean of its neighbours' (a mean, not a sum,
///   because
///      cells have unequal numbers of neighbours, at the array's poles very many).
///
/// `smooth` has as many cells as the accumulator and gets the sum, eight times the height of an even plain;
/// values beyond 2^32 − 1 become that.
Status low_pass_votes(const HoughAccumulator& accumulator, std::span<std::uint32_t> smooth) noexcept;

/// Non-maximum suppression: cells with at least `least` votes that none of their neighbours tops. Neighbours
/// are the cells of the neighbouring directions (across the poles and round the end of each row) with the
/// same, the next and the last distance; at distance 0 the antipodes' first cell. Of equal cells that are
/// neighbours the first is the peak.
///
/// `values` are the accumulator's votes or the smooth ones. `peaks` gets the peaks, most votes first, ties
/// by cell; of more than it holds the best, and output_full. size_mismatch: values of another size.
Status find_plane_peaks(const HoughAccumulator& accumulator, std::span<const std::uint32_t> values,
                        std::uint32_t least, std::span<HoughPlanePeak> peaks, std::uint32_t& count) noexcept;

}  // namespace straightedge
