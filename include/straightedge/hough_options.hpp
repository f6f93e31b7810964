// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct HoughKernels;

enum class HoughMethod : std::uint8_t {
  standard,     ///< every edge pixel votes for every angle
  progressive,  ///< random pixels vote until a line stands out; its pixels leave
  randomized,   ///< random pairs of pixels cast one vote each
};

enum class HoughGenerator : std::uint8_t {
  pcg32,   ///< our own, by `seed`; the progressive method as its paper has it
  opencv,  ///< progressive only: numbers and habits of OpenCV's HoughLinesP; `seed` is not used
};

/// A number that is NaN or outside its range gives `invalid_option`, for every method.
struct HoughOptions {
  HoughMethod method = HoughMethod::progressive;
  double rho_step = 1.0;                     ///< pixels, [1e-3, 1e5]; used as float
  double theta_step = 0.017453292519943295;  ///< radians, [1e-5, pi]; used as float
  std::int32_t threshold = 50;        ///< votes, >= 1; standard: more than it, progressive: at least it
  double min_length = 30;             ///< pixels, [0, 1e9]; shorter segments are dropped
  double max_gap = 10;                ///< pixels, [0, 1e9]; longer holes end a segment
  double half_width = 1.5;            ///< pixels, [0.5, 100], of the strip in which end points are read;
                                      ///< standard and randomized
  double min_support = 0.5;           ///< share of a segment's steps that edge pixels must carry, [0, 1];
                                      ///< standard and randomized
  std::uint32_t max_edge_pixels = 0;  ///< room for so many, 0 = every pixel may be one; more in a picture:
                                      ///< `too_large`, nothing written; progressive and randomized
  std::uint64_t seed = 1;
  HoughGenerator generator = HoughGenerator::pcg32;
  double gradient_window = 0;  ///< radians to each side of the pixel's own direction, [0, pi]; 0 = all
  double min_theta = 0;        ///< radians, standard only; 0 <= min_theta < max_theta <= pi
  double max_theta = 3.141592653589793;

  // Randomized only.
  double pair_radius = 30;          ///< pixels to the second of a pair, at most; 0 = anywhere
  double pair_min_distance = 10;    ///< pixels to the second, at least, >= 1, below pair_radius
  std::int32_t pair_threshold = 3;  ///< votes of pairs that make a line, >= 1
  double confidence = 0.99;         ///< (0, 1), that a line of min_length is not left behind
  std::uint64_t max_draws = 0;      ///< pairs; drawing ends here at the latest; 0 = 8 for each edge
                                    ///< pixel, but at least a million

  /// Progressive: how pixels vote ahead (hough_progressive.hpp). Null: one after the other. No result depends
  /// on it.
  const HoughKernels* kernels = nullptr;
};

/// A line x cos theta + y sin theta = rho in OpenCV's frame: origin at the centre of the first pixel,
/// y down, 0 <= theta <= pi, rho may be negative.
struct HoughPeak {
  float rho = 0;    ///< pixels
  float theta = 0;  ///< radians
  std::int32_t votes = 0;

  constexpr bool operator==(const HoughPeak&) const noexcept = default;
};

/// A piece of a line, its ends as columns and rows of pixels.
struct HoughSegment {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::int32_t votes = 0;   ///< in the cell of its line when the line was found
  std::int32_t pixels = 0;  ///< edge pixels that carry it

  constexpr bool operator==(const HoughSegment&) const noexcept = default;
};

struct HoughResult {
  Status status = Status::not_prepared;
  std::uint32_t peaks = 0;        ///< lines written (standard, randomized)
  std::uint32_t segments = 0;     ///< segments written
  std::uint32_t edge_pixels = 0;  ///< in the input
  std::uint64_t draws = 0;        ///< pixels or pairs drawn
  std::uint64_t seed = 0;
  bool confident = true;  ///< false: max_draws ended a randomized search before its confidence
};

/// What a trace is told about.
enum class HoughStep : std::uint8_t {
  vote,     ///< pixel (x0, y0) voted; randomized: the pair (x0, y0), (x1, y1); `votes` of the best cell
  line,     ///< a line: standard a peak (rho, theta), else the segment (x0, y0) to (x1, y1); its `votes`
  removal,  ///< pixel (x0, y0) was taken out because a line has it
};

struct HoughEvent {
  HoughStep step = HoughStep::vote;
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  float rho = 0, theta = 0;
  std::int32_t votes = 0;
};

/// Watches a run. `event` returns false to stop it, which gives `cancelled`.
struct HoughTrace {
  bool (*event)(void* user, const HoughEvent&) = nullptr;
  void* user = nullptr;

  bool operator()(const HoughEvent& e) const noexcept { return event == nullptr || event(user, e); }
};

}  // namespace straightedge
