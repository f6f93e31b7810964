// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/furniture.hpp"

#include <algorithm>
#include <cstddef>

#include "map/sample.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge {
namespace {

constexpr std::uint8_t dark_below = 128;

struct Pixel {
  std::int32_t x = 0, y = 0;
};

struct Box {
  std::int32_t left = 0, right = 0, top = 0, bottom = 0;
  std::int32_t side() const { return std::max(right - left, bottom - top) + 1; }
};

/// Step 1, for the one area that holds the seed; stops as soon as the area is larger than asked for.
class AreaMeter {
 public:
  AreaMeter(GrayView picture, double max_size)
      : picture_(picture), max_size_(max_size), seen_(picture.size(), 0) {}

  bool is_small(Pixel seed) {
    Box box{seed.x, seed.x, seed.y, seed.y};
    std::vector<Pixel> filled{seed};
    mark(seed);
    for (std::size_t next = 0; next < filled.size() && box.side() <= max_size_; ++next) {
      const Pixel at = filled[next];
      box = {std::min(box.left, at.x), std::max(box.right, at.x), std::min(box.top, at.y),
             std::max(box.bottom, at.y)};
      for (std::int32_t k = 0; k < 9; ++k) {
        const Pixel to{at.x + k % 3 - 1, at.y + k / 3 - 1};
        if (!picture_.contains(to.x, to.y) || seen_.at(to.x, to.y) != 0 ||
            picture_.at(to.x, to.y) >= dark_below)
          continue;
        mark(to);
        filled.push_back(to);
      }
    }
    for (const Pixel p : filled) seen_.at(p.x, p.y) = 0;
    return box.side() <= max_size_;
  }

 private:
  void mark(Pixel p) { seen_.at(p.x, p.y) = 1; }

  GrayView picture_;
  double max_size_;
  Image<std::uint8_t> seen_;
};

/// How far it is dark behind the face, on average, at most `most`.
double dark_depth(GrayView picture, const WallLine& face, double most) {
  double sum = 0;
  int rows = 0;
  for (double s = face.begin + 1; s < face.end; s += 1, ++rows) {
    double depth = 1;
    while (depth < most &&
           sample(picture, face.x_at(s) - depth * face.nx, face.y_at(s) - depth * face.ny) < dark_below) {
      depth += 0.5;
    }
    sum += depth;
  }
  return rows > 0 ? sum / rows : 0;
}

/// A dark pixel behind the middle of a face, as near to it as there is one.
bool dark_behind(GrayView picture, const WallLine& face, Pixel& found) {
  for (double along : {0.5, 0.35, 0.65}) {
    for (double depth = 1; depth <= 4; depth += 0.5) {
      const double s = face.begin + along * face.length();
      const auto x = static_cast<std::int32_t>(face.x_at(s) - depth * face.nx + 0.5);
      const auto y = static_cast<std::int32_t>(face.y_at(s) - depth * face.ny + 0.5);
      if (!picture.contains(x, y) || picture.at(x, y) >= dark_below) continue;
      found = {x, y};
      return true;
    }
  }
  return false;
}

}  // namespace

std::uint32_t drop_furniture(std::vector<WallLine>& lines, GrayView picture, double max_size,
                             double max_wall_width) {
  AreaMeter meter(picture, max_size);
  const std::size_t before = lines.size();
  std::erase_if(lines, [&](const WallLine& line) {  // Step 2
    Pixel seed;
    return !line.axis && line.length() <= max_size * 1.5 && dark_behind(picture, line, seed) &&
           meter.is_small(seed) && dark_depth(picture, line, max_size) > max_wall_width;
  });
  return static_cast<std::uint32_t>(before - lines.size());
}

}  // namespace straightedge
