// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "straightedge/depth_cells_cell.hpp"
#include "straightedge/detail/has_table.hpp"
#include "straightedge/frame_planes_options.hpp"
#include "straightedge/hough_accumulator.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// A number that is NaN or outside its range gives `invalid_option`.
struct HoughPatchOptions {
  PlaneGate gate = {};
  HoughAccumulatorOptions accumulator{HoughCells::ball, 30, 96};
  double max_distance_m = 8;         ///< of planes from the camera, (0, 1e6]; farther ones share a cell
  std::int32_t largest_patch = 64;   ///< pixels: 8, 16, 32 or 64
  std::int32_t smallest_patch = 8;   ///< pixels: as above, at most the largest; what is finer is passed by
  double shared_noise_pixels = 16;   ///< so many neighbours share their noise, [1, 1000]; 1: none do
  double max_spread_rad = 0.25;      ///< patches that know their normal less well do not vote, (0, 1]
  double warp_sigmas = 0.5;          ///< low bumps in the sensor's depth, in units of its noise, [0, 10]
  double bend_rad = 0.05;            ///< how much they turn a patch's normal, [0, 0.5]
  std::uint32_t min_pixels = 300;    ///< a candidate's patches have at least so many readings
  std::int32_t max_candidates = 64;  ///< [1, 1024]
  std::int32_t rounds = 2;           ///< votings; each after the first by what is left, [1, 16]
  const DepthKernels* kernels = &plain_depth_kernels;  ///< not null
};

/// The options for a search of FramePlanes with these: its gate, and planes as small as it wants.
constexpr HoughPatchOptions for_frame(HoughPatchOptions search, Size size,
                                      const FramePlanesOptions& frame) noexcept {
  const std::uint32_t least = least_pixels(size, frame);
  search.gate = widened(frame);
  if (least < search.min_pixels) search.min_pixels = least;
  return search;
}

/// A square of the depth picture whose readings lie on one plane within their noise.
struct HoughPatch {
  std::int32_t x = 0, y = 0, side = 0;  ///< first column and row, pixels
  std::uint16_t candidate = 0;          ///< the candidate that took it, counted from 1 as found; 0: none
  bool votes = false;                   ///< knows its normal well enough, and no search from it was in vain

  DepthCell cell;  ///< its readings
  InverseDepthPlane plane;
  double mean_u = 0, mean_v = 0;             ///< pixels
  double mean_q = 0;                         ///< 1/metre
  double gate = 0;                           ///< of one reading's 1/z, 1/metre
  double noise = 0;                          ///< variance of the mean of 1/z is this / cell.n
  std::array<double, 3> slope_covariance{};  ///< of plane.a and plane.b: aa, ab, bb

  Plane space;                        ///< the plane in the camera's frame
  Vector3 point;                      ///< where the mean ray meets it, metres
  Vector3 tangent_u, tangent_v;       ///< unit vectors, orthogonal to its normal
  std::array<double, 3> precision{};  ///< inverse covariance of the normal's errors along the tangents,
                                      ///< enlarged by the cell size: uu, uv, vv
  double reach_rad = 0;               ///< directions farther from the normal get no vote
};

/// A patch in short.
struct HoughPatchMean {
  double u = 0, v = 0, q = 0, gate = 0;
  std::uint32_t patch = 0;
  std::uint32_t voters = 0;  ///< its readings if it votes, else 0
};

struct HoughPatchResult {
  Status status = Status::not_prepared;
  std::uint32_t candidates = 0;  ///< written
  std::uint32_t readings = 0;
  std::uint32_t patches = 0;
  std::uint32_t votes = 0;  ///< cast by patches, all rounds
};

/// A patch's vote counts so many for each of its readings.
inline constexpr std::uint32_t hough_patch_vote = 64;
/// Side of the smallest patch, pixels.
inline constexpr std::int32_t hough_patch_side = 8;
/// Side of the largest, pixels.
inline constexpr std::int32_t most_hough_patch_side = 64;

namespace detail {

constexpr bool valid(const HoughPatchOptions& o) noexcept {
  const auto is_side = [](std::int32_t side) noexcept {
    return side == 8 || side == 16 || side == 32 || side == 64;
  };
  const bool sizes =
      is_side(o.largest_patch) && is_side(o.smallest_patch) && o.smallest_patch <= o.largest_patch;
  const bool noise = o.shared_noise_pixels >= 1 && o.shared_noise_pixels <= 1000 && o.warp_sigmas >= 0 &&
                     o.warp_sigmas <= 10 && o.bend_rad >= 0 && o.bend_rad <= 0.5;
  const bool search = o.max_distance_m > 0 && o.max_distance_m <= 1e6 && o.max_spread_rad > 0 &&
                      o.max_spread_rad <= 1 && o.max_candidates >= 1 && o.max_candidates <= 1024 &&
                      o.rounds >= 1 && o.rounds <= 16;
  return o.gate.valid() && HoughAccumulator::cell_count(o.accumulator) > 0 && sizes && noise && search &&
         has_table(o.kernels);
}

}  // namespace detail

}  // namespace straightedge
