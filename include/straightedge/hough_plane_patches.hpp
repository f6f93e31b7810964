// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/hough_plane_patch.hpp"
#include "straightedge/hough_plane_peaks.hpp"
#include "straightedge/hough_plane_trace.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

namespace detail {

/// Squared residuals of a candidate's readings: from its own plane and from the nearest rival's.
struct HoughContest {
  double own = 0, rival = 0;
};

struct HoughPatchMemory {
  DepthCells cells;         ///< squares of 8, 16 and 32 pixels
  DepthCellRows largest;    ///< squares of 64 pixels
  std::span<float> pixels;  ///< a row of the smallest squares
  std::span<HoughPatch> patches;
  std::span<HoughPatchMean> means;
  std::span<HoughPlanePeak> peaks;
  std::span<ProposedPlane> candidates;
  std::span<HoughContest> contests;  ///< of each candidate
  HoughAccumulator accumulator;

  static constexpr std::size_t squares(Size size, std::int32_t side) noexcept {
    return static_cast<std::size_t>((size.width + side - 1) / side) *
           static_cast<std::size_t>((size.height + side - 1) / side);
  }
  constexpr void take(Arena& arena, Size size, const HoughPatchOptions& options) noexcept {
    cells.take(arena, size, 1);
    const std::size_t apart = squares(size, most_hough_patch_side);
    largest = {arena.take<float>(apart * DepthCellRows::kinds).data(), static_cast<std::ptrdiff_t>(apart)};
    pixels = arena.take<float>(static_cast<std::size_t>(size.width) * hough_patch_side);
    patches = arena.take<HoughPatch>(squares(size, hough_patch_side));
    means = arena.take<HoughPatchMean>(squares(size, hough_patch_side));
    peaks = arena.take<HoughPlanePeak>(2 * static_cast<std::size_t>(options.max_candidates));
    candidates = arena.take<ProposedPlane>(static_cast<std::size_t>(options.max_candidates));
    contests = arena.take<HoughContest>(static_cast<std::size_t>(options.max_candidates));
    accumulator.take(arena, options.accumulator);
  }
};

}  // namespace detail

/// Planes of a depth picture by votes of its patches: a few hundred voters in place of 300 000, and each
/// knows how well it knows its plane.
///
///   1. Means of 1/z, u, v and sums of products of the deviations from them over squares of 8 pixels
///      (depth_cells.hpp), in one pass; four squares make one of 16, these 32 and 64 pixels. FramePlanes has
///      them already.
///   2. Patches: from the largest square down, a square whose readings lie on a plane 1/z = a u + b v + c
///      within their noise is a patch; one that does not is cut into four, down to smallest_patch. The
///      residual must not exceed the noise, nor may the mean residuals of its parts, which a crease or a
///      curve moves together.
///   3. Votes. Of a patch at point p the normal's covariance follows from that of (a, b). It votes for the
///      direction cells around its normal, each weighted by (1 − r²/6)², r the distance in standard
///      deviations (enlarged by the cell size); with direction n goes the distance n·p. The weights add up to
///      64 for each reading. Patches that know their normal less well than max_spread_rad do not vote,
///      nor do those with less than a 64th of min_pixels.
///   4. Peaks of the accumulator (hough_plane_peaks.hpp), most votes first, of those that have a
///      16th of what the readings of a candidate vote.
///   5. Growth. The largest free patch near the peak is the seed. The plane of the patches so far takes
///      in those that agree with it: the chi-square of mean and slopes, both uncertainties counted, is at
///      most 16, the mean within the gate, and the plane is known there to one sigma (near the peak to
///      three). Fit, and again, until nothing changes. Fewer readings than min_pixels: no candidate, and the
///      seed votes no more.
///   6. Steps 3 to 5 again by the patches that no candidate took, `rounds` times in all, as long as they
///      have min_pixels together: what was hidden beside a higher peak stands alone now.
///   7. A candidate whose readings the planes with more readings explain about as well, each by the nearest
///   of
///      them, leaves: patches across a crease look like a chamfer.
///
/// A pixel whose mask is not 0 does not take part. `candidates` gets the planes with most readings first.
/// A fit's covariance counts in shared_noise_pixels.
///
/// F. A. Limberger, M. M. Oliveira, "Real-time detection of planar regions in unorganized point clouds",
/// Pattern Recognition 48(6), 2015, doi:10.1016/j.patcog.2014.12.020; E. Vera, D. Lucio, L. A. F. Fernandes,
/// L. Velho, "Hough Transform for real-time plane detection in depth images", Pattern Recognition
/// Letters 103, 2018, doi:10.1016/j.patrec.2017.11.019. There the kernel lives in (theta, phi, rho); here
/// noise is in 1/z, and the kernel in the tangents of the normal, where no pole is.
///
/// Time: one pass over the pixels, then patches times the cells of their kernels. Votes are integers, so
/// that no order matters. Memory: 6 bytes a pixel and the accumulator.
///
/// Bad input: invalid_image (null views, a camera that is none), size_mismatch (another size than in
/// `prepare`), not_prepared. A picture without readings or planes gives an empty
/// result. More candidates than fit: output_full, the first ones written.
class HoughPatchSearch {
 public:
  /// Bytes that `prepare` needs; 0 when size or options are invalid, a side is above 32767 or there are more
  /// than 2^27 pixels (too_large).
  static constexpr std::size_t workspace_bytes(Size size, const HoughPatchOptions& options) noexcept {
    if (!detail::valid(options) || !fits(size)) return 0;
    Arena arena = Arena::measure();
    detail::HoughPatchMemory memory;
    memory.take(arena, size, options);
    return arena.failed() ? 0 : arena.used();
  }

  /// After a failure `search` is not prepared.
  static Status prepare(HoughPatchSearch& search, Size size, const HoughPatchOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `inverse_depth` as of inverse_depth_image; `mask` may be null. Cells of all its readings save step 1
  /// where nothing is masked.
  HoughPatchResult run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                       ImageView<const std::uint16_t> mask, std::span<ProposedPlane> candidates,
                       HoughPlaneTrace trace = {}, const DepthCells* cells = nullptr) noexcept;

  // What the last `run` left behind.

  std::span<const HoughPatch> patches() const noexcept { return memory_.patches.first(patches_); }
  /// Votes of the last round that had any.
  const HoughAccumulator& accumulator() const noexcept { return memory_.accumulator; }

 private:
  static constexpr bool fits(Size size) noexcept {
    return size.width > 0 && size.height > 0 && size.width <= 32767 && size.height <= 32767 &&
           std::int64_t{size.width} * size.height <= (1 << 27);
  }

  Size size_;
  HoughPatchOptions options_;
  detail::HoughPatchMemory memory_;
  std::size_t patches_ = 0;
};

/// As FramePlanes takes it. `search` must outlive what is returned.
PlaneSearch plane_search(HoughPatchSearch& search) noexcept;

}  // namespace straightedge
