// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "straightedge/host/image.hpp"

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

}  // namespace straightedge::cli
