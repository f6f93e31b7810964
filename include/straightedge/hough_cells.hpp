// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/hough_grid.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// How many cells an accumulator needs, and how wide: what a line through the picture can reach, and no more
/// votes than can come together. Bytes are all that is saved; no result depends on it.

/// Edge pixels for which there is room.
constexpr std::size_t hough_edge_room(Size size, const HoughOptions& options) noexcept {
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  const std::size_t most = options.max_edge_pixels;
  return most == 0 || most > pixels ? pixels : most;
}

/// Progressive: cells of all angles together, each angle's row only as long as the distances that the picture
/// reaches.
///
/// With float rounding at both ends a row has less than ((W - 1) |cos| + (H - 1) |sin|) / rho_step + 2 cells.
/// Over the angles n * step in [0, pi], |cos| falls from 1 to 0 and rises again, |sin| the other way, so
/// that the sum of either is at most its integral 2 by the step, and one more for each of the two halves.
/// (No product is followed by a sum: contraction, where a compiler does that, cannot change the number.)
constexpr std::size_t hough_row_cells(Size size, const HoughGrid& grid) noexcept {
  const double extent = size.width + size.height;
  const double angles = 2 / static_cast<double>(grid.theta_step) + 2;
  const double reached = extent / static_cast<double>(grid.rho_step) * angles;
  return static_cast<std::size_t>(reached) + 2 * static_cast<std::size_t>(grid.angles) + 1;
}

/// The number that no cell exceeds.
///
/// Progressive: the pixels of a strip that is rho_step wide; for each place along the picture's longer side
/// not more than fit into sqrt(2) rho_step along the other. With generator pcg32 also `threshold`, since a
/// pixel that brings a cell there takes its votes, all of them, off again in step 5. Randomized:
/// `pair_threshold`, since a cell that has so many is emptied in step 5 or loses one in step 4. (Standard
/// does without the bound and keeps 32 bits.)
constexpr std::int64_t hough_most_votes(Size size, const HoughOptions& options) noexcept {
  if (options.method == HoughMethod::randomized) return options.pair_threshold;
  const auto room = static_cast<std::int64_t>(hough_edge_room(size, options));
  const std::int64_t longest = size.width > size.height ? size.width : size.height;
  const std::int64_t strip = longest * (static_cast<std::int64_t>(1.4143 * options.rho_step) + 2);
  const std::int64_t most = strip < room ? strip : room;
  const bool exact = options.generator == HoughGenerator::pcg32;
  return exact && options.threshold < most ? options.threshold : most;
}

/// Bytes of a cell: 1 (never negative), 2 or 4. Following OpenCV, cells sink as far below zero as others
/// rise.
constexpr std::size_t hough_cell_bytes(Size size, const HoughOptions& options) noexcept {
  if (options.method == HoughMethod::standard) return 4;
  const bool signed_cells =
      options.method == HoughMethod::progressive && options.generator == HoughGenerator::opencv;
  const std::int64_t most = hough_most_votes(size, options);
  if (most <= UINT8_MAX && !signed_cells) return 1;
  return most <= INT16_MAX ? 2 : 4;
}

}  // namespace straightedge
