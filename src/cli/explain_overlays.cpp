// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "cli/explain_colours.hpp"
#include "cli/explain_geometry.hpp"
#include "cli/explain_pictures.hpp"
#include "cli/explain_text.hpp"
#include "io/map_colours.hpp"
#include "straightedge/host/draw.hpp"

namespace straightedge::cli {
namespace {

constexpr Rgb peak_colour{0xD6, 0x28, 0x28};
constexpr double golden_section = 0.6180339887498949;  // of the colour circle: neighbours differ most

/// The picture, pale, so that what is drawn on it stands out.
Image<Rgb> pale(const ExplainRun& run, const PictureScale& scale) {
  Image<Rgb> picture = show_gray(run.picture.gray, scale);
  for (std::int32_t y = 0; y < picture.height(); ++y) {
    for (std::int32_t x = 0; x < picture.width(); ++x) picture.at(x, y) = mix(picture.at(x, y), paper, 0.6);
  }
  return picture;
}

/// Strokes must still be seen when a large picture is shown as wide as the page.
double stroke_width(Size picture) {
  return std::max(1.6, std::max(picture.width, picture.height) / 550.0);
}

/// From columns and rows, the first pixel's centre at (0, 0), to the enlarged picture's plane.
Point2 in_picture(Point2 pixel, const PictureScale& scale) {
  return {(pixel.x + 0.5) * scale.zoom, (pixel.y + 0.5) * scale.zoom};
}

}  // namespace

Image<Rgb> show_peaks(const ExplainRun& run, const PictureScale& scale) {
  Image<Rgb> picture = pale(run, scale);
  const double width = stroke_width(picture.size());
  for (const HoughPeak& peak : run.peaks) {
    const auto chord = chord_of(peak, run.edges.size());
    if (!chord) continue;
    draw_line(picture.view(), in_picture(chord->from, scale), in_picture(chord->to, scale),
              {peak_colour, width, 0.8});
  }
  for (std::size_t i = 0; i < run.peaks.size(); ++i) {
    const auto chord = chord_of(run.peaks[i], run.edges.size());
    if (!chord) continue;
    // At places that differ, so that the numbers of neighbours do not cover one another.
    const double share = 0.08 + 0.84 * std::fmod(0.3 + golden_section * static_cast<double>(i), 1.0);
    const Point2 a = in_picture(chord->from, scale), b = in_picture(chord->to, scale);
    draw_tag(picture, std::to_string(i + 1), {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)},
             {.scale = std::max(2, static_cast<int>(width)), .colour = peak_colour});
  }
  return picture;
}

Image<Rgb> show_segments(const ExplainRun& run, const PictureScale& scale) {
  Image<Rgb> picture = pale(run, scale);
  const double width = stroke_width(picture.size());
  for (std::size_t i = 0; i < run.segments.size(); ++i) {
    const HoughSegment& s = run.segments[i];
    const Rgb colour = hue(std::fmod(golden_section * static_cast<double>(i), 1.0), 0.8);
    draw_line(picture.view(), in_picture({1.0 * s.x0, 1.0 * s.y0}, scale),
              in_picture({1.0 * s.x1, 1.0 * s.y1}, scale), {colour, width, 1});
  }
  return picture;
}

Image<Rgb> show_lines(const ExplainRun& run, const PictureScale& scale) {
  Image<Rgb> picture = pale(run, scale);
  const Size size = run.edges.size();
  const double width = stroke_width(picture.size());
  const auto draw_all = [&](auto&& stroke_of) {
    for (const MapLine& line : run.lines.map.lines) {
      for (const MapSegment& segment : line.segments) {
        const Point2 a = image_from_centre(first_end(segment), size);
        const Point2 b = image_from_centre(second_end(segment), size);
        draw_line(picture.view(), {a.x * scale.zoom, a.y * scale.zoom}, {b.x * scale.zoom, b.y * scale.zoom},
                  stroke_of(line));
      }
    }
  };
  draw_all([&](const MapLine& line) {
    return Stroke{io::axis_colour, line.width.value_or(0) * scale.zoom, line.width ? io::band_opacity : 0};
  });
  draw_all([&](const MapLine& line) {
    return Stroke{line.width ? io::axis_colour : io::face_colour, width, 1};
  });
  return picture;
}

}  // namespace straightedge::cli
