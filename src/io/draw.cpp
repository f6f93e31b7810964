// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/draw.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/image_placement.hpp"
#include "io/map_colours.hpp"

namespace straightedge {
namespace {

double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const Point2 along{b.x - a.x, b.y - a.y};
  const Point2 from_a{p.x - a.x, p.y - a.y};
  const double squared = dot(along, along);
  const double at = squared > 0 ? std::clamp(dot(from_a, along) / squared, 0.0, 1.0) : 0.0;
  const Point2 rest{from_a.x - at * along.x, from_a.y - at * along.y};
  return std::sqrt(dot(rest, rest));
}

std::uint8_t blend(std::uint8_t below, std::uint8_t above, double share) {
  return static_cast<std::uint8_t>(below + (above - below) * share + 0.5);
}

void blend_pixel(Rgb& pixel, const Rgb& colour, double share) {
  pixel = {blend(pixel.red, colour.red, share), blend(pixel.green, colour.green, share),
           blend(pixel.blue, colour.blue, share)};
}

/// The pixels from `low` to `high`, cut to [0, count).
struct Range {
  std::int32_t begin, end;
  Range(double low, double high, std::int32_t count)
      : begin(static_cast<std::int32_t>(std::clamp(std::floor(low), 0.0, 1.0 * count))),
        end(static_cast<std::int32_t>(std::clamp(std::ceil(high), 0.0, 1.0 * count))) {}
};

/// The picture's place in the map's frame, undone.
Result<io::Similarity> centre_from_map(const LineMap& map) {
  if (map.unit == MapUnit::pixel) return io::Similarity{};
  if (!map.image->placement) {
    return Failure{Problem::bad_option, "the map is in metres and does not say where its picture lies"};
  }
  return io::world_from_centre(*map.image->placement, map.image->size).inverse();
}

Image<Rgb> lightened(GrayView picture) {
  Image<Rgb> image(picture.size());
  for (std::int32_t y = 0; y < picture.height; ++y) {
    for (std::int32_t x = 0; x < picture.width; ++x) {
      const auto value = static_cast<std::uint8_t>(128 + picture.at(x, y) / 2);
      image.at(x, y) = {value, value, value};
    }
  }
  return image;
}

}  // namespace

void draw_line(ImageView<Rgb> image, Point2 a, Point2 b, const Stroke& stroke) {
  const double reach = stroke.width / 2 + 0.5;
  // Columns are walked for a flat stroke, rows for a steep one; across it only what it can reach.
  const double du = b.x - a.x;
  const double dv = b.y - a.y;
  if (!image.valid() || !std::isfinite(du + dv) || !(reach > 0)) return;
  const bool flat = std::abs(du) >= std::abs(dv);
  const Range walk = flat ? Range(std::min(a.x, b.x) - reach, std::max(a.x, b.x) + reach, image.width)
                          : Range(std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach, image.height);
  const double longer = flat ? du : dv;
  const double slope = longer != 0 ? (flat ? dv : du) / longer : 0.0;
  const double across = reach * 1.5 + 1;
  for (std::int32_t i = walk.begin; i < walk.end; ++i) {
    const double middle = flat ? a.y + (i + 0.5 - a.x) * slope : a.x + (i + 0.5 - a.y) * slope;
    const Range cut(middle - across, middle + across, flat ? image.height : image.width);
    for (std::int32_t k = cut.begin; k < cut.end; ++k) {
      const std::int32_t x = flat ? i : k;
      const std::int32_t y = flat ? k : i;
      const double cover = std::clamp(reach - distance_to_segment({x + 0.5, y + 0.5}, a, b), 0.0, 1.0);
      if (cover > 0) blend_pixel(image.at(x, y), stroke.colour, cover * stroke.opacity);
    }
  }
}

Result<Image<Rgb>> draw_line_map(GrayView picture, const LineMap& map) {
  if (!picture.valid()) return Failure{Problem::bad_option, "there is no picture to draw on"};
  if (!map.image || map.image->size != picture.size()) {
    return Failure{Problem::bad_option, "the picture is not of the size that the map states"};
  }
  const auto centre = centre_from_map(map);
  if (!centre) return centre.failure();

  Image<Rgb> image = lightened(picture);
  const auto draw_all = [&](auto&& stroke_of) {
    for (const MapLine& line : map.lines) {
      for (const MapSegment& segment : line.segments) {
        draw_line(image.view(), image_from_centre((*centre)(first_end(segment)), picture.size()),
                  image_from_centre((*centre)(second_end(segment)), picture.size()), stroke_of(line));
      }
    }
  };
  draw_all([&](const MapLine& line) {
    return Stroke{io::axis_colour, line.width.value_or(0) * centre->scale, line.width ? io::band_opacity : 0};
  });
  draw_all([](const MapLine& line) { return Stroke{line.width ? io::axis_colour : io::face_colour, 1, 1}; });
  return image;
}

}  // namespace straightedge
