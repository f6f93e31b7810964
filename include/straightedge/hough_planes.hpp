// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/hough_plane_options.hpp"
#include "straightedge/hough_plane_peaks.hpp"
#include "straightedge/hough_plane_trace.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge {

namespace detail {

struct HoughPlaneMemory {
  std::span<float> x, y, z;         ///< of the points still free, from the origin
  std::span<std::uint32_t> free;    ///< their numbers
  std::span<std::uint32_t> smooth;  ///< standard: low-passed votes
  std::span<float> voters;          ///< standard: up to 1024 that vote together; all x, all y, all z
  HoughAccumulator accumulator;

  constexpr void take(Arena& arena, std::size_t points, const HoughPlaneOptions& options) noexcept {
    x = arena.take<float>(points);
    y = arena.take<float>(points);
    z = arena.take<float>(points);
    free = arena.take<std::uint32_t>(points);
    const bool standard = options.voting == HoughPlaneVoting::standard;
    smooth = arena.take<std::uint32_t>(standard ? HoughAccumulator::cell_count(options.accumulator) : 0);
    voters = arena.take<float>(standard ? 3 * (points < 1024 ? points : 1024) : 0);
    accumulator.take(arena, options.accumulator);
  }
};

}  // namespace detail

/// Planes of a cloud by the 3D Hough transform: the textbook's voting of every point for every plane through
/// it, and the randomized one. (For depth pictures see hough_plane_patches.hpp.)
///
///   1. List the points that have readings. The accumulator's origin is the middle of their bounding box,
///      its greatest distance half the box's diagonal unless distance_step_m says another.
///   2. Votes.
///      Standard: each `every`-th point votes, in each direction n with n·p >= 0, for the distance n·p. That
///      is points times half the directions: 307 200 points and 2500 directions make 400 million votes, about
///      a second. It is here to be understood and compared with. Randomized: draw a point, a second between
///      triple_min_m and triple_max_m from it, a third likewise from both; their plane gets one vote. Draw i
///      draws from stream i of the seed.
///   3. A peak. Standard: low-pass and non-maximum suppression (hough_plane_peaks.hpp); the highest that
///   passes
///      step 4. Randomized: a cell that reaches triple_threshold.
///   4. Refit: points within one and a half distance steps and the gate of the peak's plane, fit, and three
///      times more with the gate alone. Fewer than min_points, or no wider than the gate: no plane.
///      Randomized: the cell starts anew then. Standard: eight peaks in vain end the search.
///   5. The plane's points leave. Standard: they take their votes back, every one. Randomized: all votes are
///      cleared. Back to 3.
///   6. Randomized stops when so many draws as triples_needed says have brought no plane, or at max_draws.
///   7. All points take the nearest plane (label_nearest), planes are fitted to what they got
///   (refit_labelled),
///      those with fewer than min_points leave, the one with most points comes first.
///
/// L. Xu, E. Oja, P. Kultanen, "A new curve detection method: Randomized Hough transform (RHT)", Pattern
/// Recognition Letters 11(5), 1990, doi:10.1016/0167-8655(90)90042-Z. D. Borrmann et al., 2011,
/// doi:10.1007/3DRes.02(2011)3.
///
/// Memory: 16 bytes a point and the accumulator (standard: and 4 bytes a cell and 12 KB more).
///
/// Bad input: invalid_image (no points), size_mismatch (labels), too_large (more points than `prepare` was
/// told, or more than 2^29), invalid_option, workspace_too_small, not_prepared. Fewer than three points,
/// equal ones or points on a line give an empty result. output_full: more planes than `planes` holds; the
/// largest are there.
class HoughPlanes {
 public:
  /// Bytes that `prepare` needs for clouds of up to so many points; 0 when the options are invalid.
  static constexpr std::size_t workspace_bytes(std::size_t points,
                                               const HoughPlaneOptions& options) noexcept {
    if (!detail::valid(options) || points == 0 || points > most_points) return 0;
    Arena arena = Arena::measure();
    detail::HoughPlaneMemory memory;
    memory.take(arena, points, options);
    return arena.failed() ? 0 : arena.used();
  }

  /// After a failure `search` is not prepared.
  static Status prepare(HoughPlanes& search, std::size_t points, const HoughPlaneOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `labels` has one entry a point: the index + 1 of its plane, or 0.
  Status run(const PointsView& points, std::span<std::uint16_t> labels, std::span<FoundPlane> planes,
             PlanesFound& found, HoughPlaneTrace trace = {}) noexcept;

  // What the last `run` left behind.

  /// Votes since the last plane was found. Planes are relative to `origin`.
  const HoughAccumulator& accumulator() const noexcept { return memory_.accumulator; }
  const Vector3& origin() const noexcept { return origin_; }
  /// False: max_draws ended a randomized search before its confidence.
  bool confident() const noexcept { return confident_; }

 private:
  static constexpr std::size_t most_points = std::size_t{1} << 29U;

  std::size_t capacity_ = 0;
  HoughPlaneOptions options_;
  detail::HoughPlaneMemory memory_;
  Vector3 origin_;
  bool confident_ = true;
};

/// Step 6. Of N points left a plane has at least m = min_points. A triple, each point as likely as any, lies
/// on it with probability p >= (m/N)((m−1)/(N−1))((m−2)/(N−2)); drawing near the first raises p, if the
/// plane's share among the points near one of its own is not smaller than in the whole. Its votes fall into c
/// cells, taken as 8 (noise and borders). Then D draws give the fullest cell D p / c votes on the mean, and
/// by Chernoff's bound fewer than T = triple_threshold with a chance below 1 − confidence when
///   sqrt(D p / c) >= (sqrt(2 k) + sqrt(2 k + 4 T)) / 2,  k = −ln(1 − confidence).
/// The number of draws, at most 4e18.
std::uint64_t triples_needed(std::size_t points_left, const HoughPlaneOptions& options) noexcept;

}  // namespace straightedge
