// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/host/image.hpp"

namespace straightedge {

struct Pixel {
  std::int32_t x = 0, y = 0;
};

/// The smallest upright square that some pixels fit into.
struct Square {
  std::int32_t left = 0, right = 0, top = 0, bottom = 0;
  std::int32_t side() const { return std::max(right - left, bottom - top) + 1; }
};

/// Marks of pixels in memory that is kept: all are 0 at the beginning, and who sets some takes them off.
inline ImageView<std::uint8_t> marks_of(Image<std::uint8_t>& memory, Size size) {
  if (memory.size() != size) memory = Image<std::uint8_t>(size);
  return memory.view();
}

/// Flood fill with a list in place of recursion: collects in `area` the pixels that hang together with the
/// seed (8-neighbours) and are `inside`, and marks them in `seen`, whose other pixels are 0 where they may be
/// taken. Stops early when the area no longer fits into a square of `enough` pixels.
template <class Inside>
Square grow_area(Pixel seed, ImageView<std::uint8_t> seen, double enough, std::vector<Pixel>& area,
                 const Inside& inside) {
  constexpr std::uint8_t taken = 255;
  Square square{seed.x, seed.x, seed.y, seed.y};
  area.assign(1, seed);
  seen.at(seed.x, seed.y) = taken;
  for (std::size_t next = 0; next < area.size() && square.side() <= enough; ++next) {
    const Pixel at = area[next];
    square = {std::min(square.left, at.x), std::max(square.right, at.x), std::min(square.top, at.y),
              std::max(square.bottom, at.y)};
    for (std::int32_t k = 0; k < 9; ++k) {
      const Pixel to{at.x + k % 3 - 1, at.y + k / 3 - 1};
      if (!seen.contains(to.x, to.y) || seen.at(to.x, to.y) != 0 || !inside(to)) continue;
      seen.at(to.x, to.y) = taken;
      area.push_back(to);
    }
  }
  return square;
}

}  // namespace straightedge
