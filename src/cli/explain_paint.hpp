// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "straightedge/host/draw.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {

/// A pixel's side in the pictures: small ones are enlarged to about 640 pixels.
inline int zoom_of(Size size) {
  return std::clamp(640 / std::max(size.width, size.height), 1, 64);
}

/// A picture of this size, enlarged, in which the function says the colour of each pixel.
template <class Colour>
Image<Rgb> paint(Size size, int zoom, Colour colour) {
  Image<Rgb> picture(Size{size.width * zoom, size.height * zoom});
  for (std::int32_t y = 0; y < size.height; ++y) {
    Rgb* first = picture.view().row(y * zoom);
    for (std::int32_t x = 0; x < size.width; ++x) {
      const Rgb value = colour(x, y);
      std::fill_n(first + x * zoom, zoom, value);
    }
    for (int k = 1; k < zoom; ++k) std::copy_n(first, picture.width(), picture.view().row(y * zoom + k));
  }
  return picture;
}

inline void draw_circle(Image<Rgb>& picture, Point2 middle, double radius, const Stroke& stroke) {
  const int steps = std::max(24, static_cast<int>(radius));
  Point2 last{middle.x + radius, middle.y};
  for (int k = 1; k <= steps; ++k) {
    const double angle = 2 * pi * k / steps;
    const Point2 next{middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
    draw_line(picture.view(), last, next, stroke);
    last = next;
  }
}

}  // namespace straightedge::cli
