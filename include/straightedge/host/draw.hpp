// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/image.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

struct Stroke {
  Rgb colour;
  double width = 1;    ///< pixels
  double opacity = 1;  ///< 0 to 1
};

/// A straight stroke with soft edges and round ends, between two points of the image plane (u right, v down,
/// pixel (c, r) covers [c, c+1] x [r, r+1]). A pixel is covered by how near its centre is:
/// clamp(width/2 + 1/2 − distance, 0, 1). What lies outside of the image is left out. Ends that are not
/// finite draw nothing. Cost: the pixels of the stroke.
void draw_line(ImageView<Rgb> image, Point2 a, Point2 b, const Stroke& stroke);

/// The map over its own picture, which is lightened: colours as in the SVG drawing (svg.hpp), without ids.
/// Fails with `bad_option` when the picture is not of the size that the map states, or a metre map does not
/// say where its picture lies.
Result<Image<Rgb>> draw_line_map(GrayView picture, const LineMap& map);

}  // namespace straightedge
