// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/furniture.hpp"

#include <cstddef>

#include "map/area.hpp"
#include "map/sample.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge {
namespace {

constexpr std::uint8_t dark_below = 128;

/// Step 1, for the one area that holds the seed.
class AreaMeter {
 public:
  AreaMeter(GrayView picture, double max_size, Image<std::uint8_t>& marks)
      : picture_(picture), max_size_(max_size), seen_(marks_of(marks, picture.size())) {}

  bool is_small(Pixel seed) {
    const Square square =
        grow_area(seed, seen_, max_size_, area_, [&](Pixel p) { return picture_.at(p.x, p.y) < dark_below; });
    for (const Pixel p : area_) seen_.at(p.x, p.y) = 0;
    return square.side() <= max_size_;
  }

 private:
  GrayView picture_;
  double max_size_;
  ImageView<std::uint8_t> seen_;
  std::vector<Pixel> area_;
};

/// How far it is dark behind the face, on average, at most `most`.
double dark_depth(GrayView picture, const WallLine& face, double most) {
  double sum = 0;
  int rows = 0;
  for (double s = face.begin + 1; s < face.end; s += place_step(face.length()), ++rows) {
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
                             double max_wall_width, Image<std::uint8_t>& marks) {
  AreaMeter meter(picture, max_size, marks);
  const std::size_t before = lines.size();
  std::erase_if(lines, [&](const WallLine& line) {  // Step 2
    Pixel seed;
    return !line.axis && line.length() <= max_size * 1.5 && dark_behind(picture, line, seed) &&
           meter.is_small(seed) && dark_depth(picture, line, max_size) > max_wall_width;
  });
  return static_cast<std::uint32_t>(before - lines.size());
}

}  // namespace straightedge
