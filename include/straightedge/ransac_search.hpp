// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/image.hpp"
#include "straightedge/ransac_search_memory.hpp"
#include "straightedge/ransac_search_options.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct RansacSearchResult {
  Status status = Status::not_prepared;
  std::uint32_t candidates = 0;  ///< written, strongest first
  std::uint32_t readings = 0;    ///< of the finest cells
  std::uint32_t explained = 0;   ///< of these, how many a candidate owns
  double noise = 1;              ///< the gate was so many times as wide as the options say
  std::uint32_t windows = 0;     ///< searched
  std::uint32_t draws = 0;       ///< triples tried
  std::uint64_t seed = 0;
};

/// Candidate planes of a depth frame, large and small, for a labelling that gives each pixel the best of
/// them.
///
///   1. The frame's noise: residuals of the coarsest cells' pixels from their own best plane, the lower
///      quartile. A frame that is noisier than gate.inverse_sigma gets a wider gate.
///   2. Readings are means of cells of three sizes: `cell`, twice and four times that. Cells that are curved
///      or of two surfaces, whose pixels leave too much from their own plane, are none; the smaller cells in
///      them may be. Means stray less than pixels: their gate is 0.4 of the pixels'.
///   3. From the coarsest cells to the finest: windows of 13 x 13 cells, 8 apart; none on cells of which the
///      smallest plane fills more than a window. In each, RANSAC among the readings that are left: sixteen
///      triples at a time, their MSAC costs in the window, refits of the best with a threshold from wide to
///      narrow, until the stop rule or max_draws. The readings of a window are near one another, so that a
///      face of 1000 pixels among 300 000, hopeless for triples from the whole frame, is found in a few
///      draws.
///   4. Grow, in the same cells: refit to the readings within the gate in boxes four times as large each, at
///      last in the frame, until the plane ends inside its box; in the frame again while that doubles it. A
///      reading counts if three of its eight neighbours do too. Refused are planes with less than min_pixels
///      (24 of coarse cells) and those whose residuals fill the gate (rms > max_rms, in the window already or
///      in a box): noise leaves a third or less, the compromise between two surfaces, or a curved one, near
///      0.58. The others are candidates, and what lies within the whole gate of the pixels leaves, in cells
///      of all sizes.
///   5. Planes that were refused for their residuals grow again, with rough_rms in place of max_rms,
///      among what is left: those refused first, at most two for each of max_candidates.
///   6. Sorted by score.
///
/// A strip in which no two whole cells of the smallest size lie side by side is no plane here: with cells of
/// 4 pixels those below 8, and some below 11.
///
/// Papers: ransac_planes.hpp. Deterministic: window i draws from stream i of the seed; all sums have a fixed
/// order, the same for every table of kernels.
///
/// Time: what a plane costs grows with its extent, what is no plane costs a microsecond a window; for 640x480
/// pixels with the defaults an eighth of a millisecond in an empty room to a third in clutter. Memory: 30
/// bytes for each of the finest cells, and 20 KB. A frame without readings, or with noise alone, has no
/// candidates.
class RansacSearch {
 public:
  /// 0 for a size or options that `prepare` refuses.
  static constexpr std::size_t workspace_bytes(Size size, const RansacSearchOptions& options) noexcept {
    if (!fits(size) || !detail::valid(options)) return 0;
    Arena arena = Arena::measure();
    (void)detail::RansacSearchMemory::take(arena, size, options);
    return arena.used();
  }
  /// invalid_image: a side below 1 or above 2^15; invalid_option; workspace_too_small.
  static Status prepare(RansacSearch& search, Size size, const RansacSearchOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `cells`: of a frame of the size that was prepared for, down to `cell` pixels at least. Cells with z
  /// beyond the depth at which the gate reaches infinity are no readings. `mask`: cells with a pixel that is
  /// not 0 take no part; a view without data masks nothing. output_full: `out` holds the strongest.
  /// size_mismatch: cells or a mask of another size.
  RansacSearchResult run(const DepthCells& cells, ImageView<const std::uint16_t> mask,
                         std::span<ProposedPlane> out) noexcept;

 private:
  static constexpr bool fits(Size size) noexcept {
    return size.width >= 1 && size.height >= 1 && size.width <= 32768 && size.height <= 32768;
  }

  Size size_{};
  RansacSearchOptions options_;
  detail::RansacSearchMemory memory_;
  bool prepared_ = false;
};

/// As FramePlanes takes it. `search` must outlive what is returned.
PlaneSearch plane_search(RansacSearch& search) noexcept;

}  // namespace straightedge
