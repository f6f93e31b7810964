// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

enum class HoughMethod : std::uint8_t {
  standard,     ///< every edge pixel votes for every angle
  progressive,  ///< random pixels vote until a line stands out; its pixels leave
  randomized,   ///< random pairs of pixels cast one vote each
};

enum class HoughGenerator : std::uint8_t {
  pcg32,   ///< our own, by `seed`
  opencv,  ///< the numbers of OpenCV's HoughLinesP, for comparison; `seed` is not used
};

struct HoughOptions {
  HoughMethod method = HoughMethod::progressive;
  double rho_step = 1.0;                    ///< pixels
  double theta_step = 0.017453292519943295; ///< radians
  int threshold = 50;                       ///< votes
  double min_length = 30;                   ///< pixels
  double max_gap = 10;                      ///< pixels
  std::uint64_t seed = 1;
  HoughGenerator generator = HoughGenerator::pcg32;
  double gradient_window = 0;  ///< radians to each side of the pixel's own direction; 0 = all angles
  double min_theta = 0;        ///< standard only, radians
  double max_theta = 3.141592653589793;
  // Randomized only.
  double pair_radius = 30;     ///< the second pixel lies no farther from the first; 0 = anywhere
  double confidence = 0.99;    ///< that no line of min_length is left when drawing ends
};

/// A line in OpenCV's frame: origin at the centre of the first pixel, y down, rho may be negative.
struct HoughPeak {
  float rho = 0;
  float theta = 0;
  std::int32_t votes = 0;
};

/// End points as columns and rows of pixels.
struct HoughSegment {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::int32_t votes = 0;
};

struct HoughResult {
  Status status = Status::not_prepared;
  std::uint32_t peaks = 0;     ///< lines written (standard, randomized)
  std::uint32_t segments = 0;  ///< segments written
  std::uint32_t edge_pixels = 0;
  std::uint64_t draws = 0;     ///< pixels or pairs drawn
  std::uint64_t seed = 0;
};

}  // namespace straightedge
