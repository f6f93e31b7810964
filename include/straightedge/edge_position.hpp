// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"

namespace straightedge {

/// Where between the pixels an edge runs.
struct EdgePosition {
  double x = 0;         ///< column; the centre of the first pixel is 0
  double y = 0;         ///< row
  double variance = 0;  ///< squared pixels, across the edge
};

/// An edge pixel as a line fit wants it.
struct EdgePoint {
  double x = 0;       ///< column of its position
  double y = 0;       ///< row
  double weight = 0;  ///< 1 / variance
  std::int16_t dx = 0;
  std::int16_t dy = 0;
};

/// What Canny leaves behind: the gradient (right minus left, below minus above) and its magnitude.
struct GradientField {
  ImageView<const std::int16_t> x;
  ImageView<const std::int16_t> y;
  ImageView<const std::int32_t> magnitude;

  bool valid() const noexcept {
    return x.valid() && y.valid() && magnitude.valid() && x.size() == y.size() &&
           x.size() == magnitude.size();
  }
};

/// Sub-pixel position of the edge at pixel (x, y), which must lie inside the field.
///
/// 1. Look across the edge along the image axis that is nearest to the gradient's direction.
/// 2. The largest of the three magnitudes there is the top. It is the pixel's own where the pixels come from
///    the same field; they may come from another version of the picture, a pixel off.
/// 3. Lay a parabola through the top and its two neighbours; its vertex is where the edge crosses that row or
///    column (a straight edge crosses it at the right place whatever its slope).
/// 4. The sharper the parabola, the surer the place: variance = floor² + (noise / curvature)².
///
/// F. Devernay, "A non-maxima suppression method for edge detection with sub-pixel accuracy",
/// INRIA RR-2724, 1995. Within two pixels of the image's border the pixel's centre is returned.
EdgePosition edge_position(const GradientField& field, std::int32_t x, std::int32_t y) noexcept;

/// The same with the gradient.
inline EdgePoint edge_point(const GradientField& field, std::int32_t x, std::int32_t y) noexcept {
  const EdgePosition edge = edge_position(field, x, y);
  return {edge.x, edge.y, 1 / edge.variance, field.x.at(x, y), field.y.at(x, y)};
}

}  // namespace straightedge
