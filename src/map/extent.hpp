// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/picture.hpp"
#include "map/wall_line.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

struct ExtentOptions {
  double max_gap = 10;  ///< pixels; a hole in the wall up to this long is bridged
  double max_wall_width = 3.6;
};

/// Reads from the picture where along its line a wall begins and ends, between the pixels.
///
/// 1. Sample the gray along the line, every second pixel: on the dark side and on the light side of a face;
///    at the core and on both sides of an axis. Half of the way between the usual dark and the usual light
///    divides wall from floor.
/// 2. A step is wall (dark is dark, light is light), hole (the dark side is light) or blocked (the light
///    side is dark: another wall stands there).
/// 3. Runs of wall across short holes are one piece. A blocked stretch ends a face, for the face is not
///    there; an axis goes on through a wall that is thin.
/// 4. Every piece that the line's own edge pixels reach is a segment; its ends are where the gray crosses the
///    half, so neither blur nor the pixel grid moves them. A piece more than twice as long as the edge goes on
///    along another one, round a bend: it ends where the edge does.
/// `blurred` is the picture as Canny saw it, after its blur. Lines whose dark side is no wall by the map's
/// thresholds are left out.
std::vector<WallLine> measure_extents(const std::vector<WallLine>& lines, const Picture& picture,
                                      GrayView blurred, const ExtentOptions& options,
                                      const PictureRowKernels& kernels = plain_picture_row_kernels);

}  // namespace straightedge
