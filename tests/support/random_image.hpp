// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/random.hpp"
#include "support/guarded_image.hpp"

namespace support {

using GrayImage = GuardedImage<std::uint8_t>;

/// Any byte anywhere.
inline GrayImage random_bytes(straightedge::Size size, straightedge::Pcg32& random, int gap = 5) {
  GrayImage image(size, gap);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) image.at(x, y) = static_cast<std::uint8_t>(random.below(256));
  }
  return image;
}

/// Even rectangles over one another, with a little noise: edges of all lengths and heights.
inline GrayImage random_scene(straightedge::Size size, straightedge::Pcg32& random, std::uint32_t noise = 4) {
  GrayImage image(size, 3, std::uint8_t{128});
  const auto draw = [&](int n) { return static_cast<int>(random.below(static_cast<std::uint32_t>(n))); };
  for (int i = 0; i < 12; ++i) {
    const int x0 = draw(size.width), y0 = draw(size.height);
    const int x1 = x0 + 1 + draw(size.width - x0), y1 = y0 + 1 + draw(size.height - y0);
    const auto level = static_cast<std::uint8_t>(20 + draw(200));
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) image.at(x, y) = level;
    }
  }
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(image.at(x, y) + random.below(noise + 1));
    }
  }
  return image;
}

}  // namespace support
