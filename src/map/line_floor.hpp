// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "map/picture.hpp"
#include "map/wall_line.hpp"
#include "straightedge/line_fit.hpp"

namespace straightedge {

/// The error of a line that its pixels have in common, so that no number of them averages it away. Standard
/// deviations in pixels, measured on floor plans with exact truth (docs/line-map.md):
///   - crisp picture, line along rows or columns: the wall's edge was rounded to the next pixel, uniformly
///     within half a pixel to each side, and 1/sqrt(12) = 0.29;
///   - axis in a picture with gray: ground of different lightness on its two sides draws it to one of them;
///   - everything else: a twentieth of a pixel, a tenth under noise, which bends edges over tens of pixels.
LineFloor line_floor(const PictureFacts& picture, const WallLine& line);

}  // namespace straightedge
