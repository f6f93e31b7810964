// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "straightedge/host/image.hpp"

namespace straightedge::cli {

inline constexpr Rgb strong_colour{0xFF, 0xD1, 0x4D};
inline constexpr Rgb weak_colour{0x3D, 0x8B, 0xE8};
inline constexpr Rgb waiting_colour{0x7C, 0x84, 0x8E};
inline constexpr Rgb taken_colour{0xE8, 0x4A, 0x3C};
inline constexpr Rgb marker_colour{0x35, 0xE0, 0xFF};
inline constexpr Rgb ink{0x22, 0x26, 0x2B};
inline constexpr Rgb paper{0xFF, 0xFF, 0xFF};

inline unsigned char level(double share) {
  return static_cast<unsigned char>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// Between two colours; share 0 is the first.
inline Rgb mix(Rgb a, Rgb b, double share) {
  const auto one = [share](unsigned char from, unsigned char to) {
    return static_cast<unsigned char>(std::lround(from + (to - from) * std::clamp(share, 0.0, 1.0)));
  };
  return {one(a.red, b.red), one(a.green, b.green), one(a.blue, b.blue)};
}

/// A hue (in turns: 0 red, 1/3 green, 2/3 blue) at a brightness from 0 to 1.
inline Rgb hue(double turns, double brightness) {
  const auto channel = [&](double shift) {
    const double place = 6 * (turns + shift - std::floor(turns + shift));
    return level(brightness * std::clamp(std::abs(place - 3) - 1, 0.0, 1.0));
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

/// From black by violet and orange to white: brighter all the way, so it can be read in gray, too.
inline Rgb heat(double share) {
  constexpr Rgb stops[] = {{6, 4, 20},     {74, 16, 108},  {176, 40, 94},
                           {237, 105, 37}, {251, 186, 50}, {255, 253, 224}};
  constexpr int last = static_cast<int>(std::size(stops)) - 1;
  const double place = last * std::clamp(share, 0.0, 1.0);
  const int i = std::min(static_cast<int>(place), last - 1);
  return mix(stops[i], stops[i + 1], place - i);
}

}  // namespace straightedge::cli
