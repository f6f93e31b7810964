// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "straightedge/image.hpp"

namespace straightedge {

/// The way from one place to the next along a stretch, in pixels, where 32 places tell as much as all.
inline double place_step(double length) {
  return length > 32 ? length / 32 : 1;
}

/// Gray between the pixels, bilinear; coordinates beyond the border read the border.
inline double sample(GrayView image, double x, double y) {
  const double last_x = image.width - 1;
  const double last_y = image.height - 1;
  x = x < 0 ? 0 : x > last_x ? last_x : x;
  y = y < 0 ? 0 : y > last_y ? last_y : y;
  const auto c = static_cast<std::int32_t>(x);
  const auto r = static_cast<std::int32_t>(y);
  const double fx = x - c;
  const double fy = y - r;
  const std::int32_t c1 = c + 1 < image.width ? c + 1 : c;
  const std::int32_t r1 = r + 1 < image.height ? r + 1 : r;
  const double top = image.at(c, r) * (1 - fx) + image.at(c1, r) * fx;
  const double bottom = image.at(c, r1) * (1 - fx) + image.at(c1, r1) * fx;
  return top * (1 - fy) + bottom * fy;
}

}  // namespace straightedge
