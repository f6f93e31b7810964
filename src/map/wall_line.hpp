// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "straightedge/line_fit.hpp"
#include "straightedge/segment_refit.hpp"

namespace straightedge {

/// A stretch along a line.
struct Span {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
};

/// A straight piece of wall on its way into the map: one face of a thick wall (or any edge of a photo), or
/// the axis of a thin one. Coordinates are columns and rows, the first pixel's centre is (0, 0).
struct WallLine {
  LineMoments moments;  ///< of its edge pixels, about (origin_x, origin_y)
  double origin_x = 0;
  double origin_y = 0;
  LineFit fit;            ///< without the floor
  double nx = 1, ny = 0;  ///< unit normal; of a face: towards the light side
  double begin = 0;       ///< extent along (−ny, nx), from the centroid
  double end = 0;
  bool axis = false;
  double width = 0;        ///< pixels, of an axis
  bool free_plus = false;  ///< open floor on the side of the normal
  bool free_minus = false;
  std::uint32_t pixels = 0;
  std::uint32_t votes = 0;
  std::uint32_t count = 1;  ///< edges that were joined into it

  double length() const { return end - begin; }
  double tx() const { return -ny; }
  double ty() const { return nx; }
  double along(double x, double y) const { return (x - fit.centroid_x) * tx() + (y - fit.centroid_y) * ty(); }
  double across(double x, double y) const { return (x - fit.centroid_x) * nx + (y - fit.centroid_y) * ny; }
  double x_at(double s) const { return fit.centroid_x + s * tx(); }
  double y_at(double s) const { return fit.centroid_y + s * ty(); }

  /// Where the other line lies, along this one.
  Span span_of(const WallLine& other) const;

  /// Takes new moments (about an origin of its own) and the line that they make; end points stay where
  /// they are in the picture, moved onto the new line.
  void adopt(const LineMoments& sums, double about_x, double about_y);
};

void sort_longest_first(std::vector<WallLine>& lines);

/// The axis or face as the Hough transform's refit left it.
WallLine wall_line_from(const RefinedSegment& segment, std::uint32_t votes);

}  // namespace straightedge
