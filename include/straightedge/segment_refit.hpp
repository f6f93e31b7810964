// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/edge_position.hpp"
#include "straightedge/hough_lines.hpp"
#include "straightedge/image.hpp"
#include "straightedge/line_fit.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct RefitOptions {
  double corridor = 0.9;  ///< pixels to each side of the line in which its edge pixels lie; 0.5..8
  double max_angle =
      0.4363323129985824;  ///< radians between a pixel's gradient and the line's normal; 0..pi/2
  double max_gap = 10;     ///< pixels; a longer hole ends the segment
  int rounds = 4;          ///< of collecting and fitting, at most; 1..20
};

/// A straight edge, known better than to a pixel. Coordinates are columns and rows, the first pixel's
/// centre is (0, 0).
struct RefinedSegment {
  LineMoments moments;  ///< of the edge pixels, about (origin_x, origin_y)
  double origin_x = 0;
  double origin_y = 0;
  LineFit fit;         ///< in image coordinates, without the floor
  double light_x = 1;  ///< unit normal that points to the lighter side
  double light_y = 0;
  double begin = 0;  ///< extent along (−light_y, light_x), from the centroid; begin < end
  double end = 0;
  std::uint32_t pixels = 0;  ///< edge pixels that carry it

  double length() const noexcept { return end - begin; }
};

/// Finds the line that the edge pixels near a rough segment form, and how far it goes.
///
/// 1. Which side is light: the sign that most gradients in the corridor have, looked at in 48 places at most.
/// 2. Walk from the segment's middle to both ends and on, collecting the edge pixels of the corridor
///    whose gradient points to the light side within max_angle, until a hole is longer than max_gap.
/// 3. Take each pixel's sub-pixel position (edge_position.hpp) and weight, fit a line, go to 2; at most
///    `rounds` times, and no more when the pixels are those of the round before, or the line hardly moves.
/// 4. Before the last round, or when the pixels stay the same: when the two halves lie on lines a step apart,
///    they are two walls that nearly continue one another; go on with the larger half in a corridor half as
///    wide.
///
/// `mask` says which edge pixels may be used (non-zero). Cost: proportional to the segment's length.
/// Nothing near: `pixels` is 0. invalid_option, invalid_image, size_mismatch as named.
Status refit_segment(GrayView mask, const GradientField& field, const HoughSegment& rough,
                     const RefitOptions& options, RefinedSegment& refined) noexcept;

/// Clears from the mask the edge pixels that belong to a segment: those within `corridor` of it whose
/// gradient points to its light side within max_angle, from `margin` before its begin to `margin` after its
/// end. Returns how many.
std::uint32_t claim_pixels(ImageView<std::uint8_t> mask, const GradientField& field,
                           const RefinedSegment& segment, double corridor, double max_angle,
                           double margin) noexcept;

}  // namespace straightedge
