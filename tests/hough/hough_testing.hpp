// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cmath>
#include <cstdint>
#include <vector>

#include "straightedge/host/hough_lines.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/random.hpp"

namespace straightedge::test {

using EdgeImage = Image<std::uint8_t>;

inline EdgeImage noise(Size size, double share, std::uint64_t seed) {
  EdgeImage image(size);
  Pcg32 random(seed);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (random.below(1'000'000) < share * 1e6) image.at(x, y) = 255;
  return image;
}

/// One pixel a step along the longer axis, ends included.
inline void draw(EdgeImage& image, int x0, int y0, int x1, int y1) {
  const int steps = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0 : static_cast<double>(i) / steps;
    const int x = static_cast<int>(std::lround(x0 + t * (x1 - x0)));
    const int y = static_cast<int>(std::lround(y0 + t * (y1 - y0)));
    if (image.view().contains(x, y)) image.at(x, y) = 255;
  }
}

inline double length(const HoughSegment& s) {
  return std::hypot(s.x1 - s.x0, s.y1 - s.y0);
}

/// Both ends within `tolerance` of those given, in either order.
inline bool same_ends(const HoughSegment& s, int x0, int y0, int x1, int y1, double tolerance) {
  const auto near = [tolerance](int ax, int ay, int bx, int by) {
    return std::hypot(ax - bx, ay - by) <= tolerance;
  };
  return (near(s.x0, s.y0, x0, y0) && near(s.x1, s.y1, x1, y1)) ||
         (near(s.x0, s.y0, x1, y1) && near(s.x1, s.y1, x0, y0));
}

/// A gradient across every pixel that points along `angle`.
struct ConstantGradient {
  Image<std::int16_t> dx;
  Image<std::int16_t> dy;
  ConstantGradient(Size size, double angle)
      : dx(size, static_cast<std::int16_t>(std::lround(1000 * std::cos(angle)))),
        dy(size, static_cast<std::int16_t>(std::lround(1000 * std::sin(angle)))) {}
  GradientView view() const { return {dx.view(), dy.view()}; }
};

}  // namespace straightedge::test
