// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "straightedge/host/line_geometry.hpp"

namespace straightedge::io {

/// From a map's frame (y up) to a drawing (y down): scale, and the map's point at the upper left corner.
struct SvgCanvas {
  double scale = 1;
  Point2 upper_left;
  double width = 0;  ///< of the drawing
  double height = 0;

  constexpr Point2 operator()(Point2 p) const noexcept {
    return {scale * (p.x - upper_left.x), scale * (upper_left.y - p.y)};
  }
};

/// The box round points.
struct Bounds {
  double left = std::numeric_limits<double>::infinity();
  double bottom = left;
  double right = -left;
  double top = -left;

  void include(Point2 p) noexcept {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    bottom = std::min(bottom, p.y);
    top = std::max(top, p.y);
  }
  bool empty() const noexcept { return !(left <= right); }
};

/// Room for the whole picture of a pixel map, magnified by a whole number.
inline SvgCanvas canvas_of_picture(Size size, double wanted) noexcept {
  const double longer = std::max(size.width, size.height);
  double scale = 1;
  while (scale * longer < wanted && scale < 32) ++scale;
  return {scale, {-0.5 * size.width, 0.5 * size.height}, scale * size.width, scale * size.height};
}

/// Room for the box and a margin, its longer side as long as wanted.
inline SvgCanvas canvas_of_bounds(Bounds bounds, double wanted) noexcept {
  if (bounds.empty()) bounds = {-0.5, -0.5, 0.5, 0.5};
  double extent = std::max(bounds.right - bounds.left, bounds.top - bounds.bottom);
  if (!(extent > 0)) extent = 1;
  const double margin = 0.04 * extent;
  const double scale = wanted / (extent + 2 * margin);
  return {scale,
          {bounds.left - margin, bounds.top + margin},
          scale * (bounds.right - bounds.left + 2 * margin),
          scale * (bounds.top - bounds.bottom + 2 * margin)};
}

}  // namespace straightedge::io
