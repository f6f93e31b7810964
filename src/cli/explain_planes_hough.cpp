// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_planes_hough.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/explain_chart.hpp"
#include "cli/explain_colours.hpp"
#include "cli/explain_depth_pictures.hpp"
#include "cli/explain_paint.hpp"
#include "cli/explain_text.hpp"
#include "straightedge/host/draw.hpp"
#include "straightedge/host/label_picture.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t disc = 640, border = 80;  // pixels
constexpr double edge_degrees = 125;
constexpr double ring_radius = 9;
constexpr Rgb bare_colour{0xC4, 0xC9, 0xD0};
constexpr Rgb rival_colour{0xFF, 0xFF, 0xFF};

double radius_of(double degrees) {
  return disc / 2.0 * std::sin(degrees * degree / 2) / std::sin(edge_degrees * degree / 2);
}

/// Lambert's azimuthal projection; x right, y down, z into the picture.
Point2 on_disc(const Vector3& n) {
  const double middle = border + disc / 2.0, side = std::hypot(n.x, n.y);
  if (side == 0) return {middle, middle};
  const double radius = radius_of(std::atan2(side, n.z) / degree);
  return {middle + radius * n.x / side, middle + radius * n.y / side};
}

/// The direction of a place on the disc; false outside.
bool from_disc(double x, double y, Vector3& n) {
  const double u = x - border - disc / 2.0, v = y - border - disc / 2.0, radius = std::hypot(u, v);
  if (radius > disc / 2.0) return false;
  const double angle = 2 * std::asin(2 * radius / disc * std::sin(edge_degrees * degree / 2));
  const double side = radius > 0 ? std::sin(angle) / radius : 0;
  n = {u * side, v * side, std::cos(angle)};
  return true;
}

std::vector<std::uint32_t> best_of_directions(const HoughAccumulator& accumulator) {
  std::vector<std::uint32_t> best(static_cast<std::size_t>(accumulator.directions().size()));
  for (std::int32_t d = 0; d < accumulator.directions().size(); ++d) {
    for (std::int32_t k = 0; k < accumulator.distances(); ++k)
      best[static_cast<std::size_t>(d)] =
          std::max(best[static_cast<std::size_t>(d)], accumulator.votes(d, k));
  }
  return best;
}

void draw_rings(Image<Rgb>& picture) {
  const Point2 middle{border + disc / 2.0, border + disc / 2.0};
  for (const int degrees : {30, 60, 90}) {
    draw_circle(picture, middle, radius_of(degrees), {paper, 1, 0.35});
    draw_text(picture.view(), std::to_string(degrees),
              {.x = static_cast<std::int32_t>(middle.x + 0.7071 * radius_of(degrees)) + 4,
               .y = static_cast<std::int32_t>(middle.y - 0.7071 * radius_of(degrees)) - 14,
               .scale = 2,
               .colour = bare_colour});
  }
  const auto write = [&](const char* text, double x, double y) {
    const Size size = text_size(text, 2);
    draw_text(picture.view(), text,
              {.x = static_cast<std::int32_t>(x) - size.width / 2,
               .y = static_cast<std::int32_t>(y) - size.height / 2,
               .scale = 2,
               .colour = ink});
  };
  write("ceiling", middle.x, border - 20.0);
  write("floor", middle.x, disc + border + 20.0);
  write("left", border / 2.0, middle.y);
  write("right", disc + 1.5 * border, middle.y);
}

/// Rings that fall on one place share it and name all of their candidates.
struct Ring {
  Point2 at;
  std::string numbers;
};

std::vector<Ring> rings_of(const HoughStage& stage) {
  std::vector<Ring> rings;
  for (std::size_t number = 1; number <= std::min(stage.candidates.size(), shown_planes); ++number) {
    const auto grown = std::find_if(stage.planes.begin(), stage.planes.end(),
                                    [&](const GrownPlane& plane) { return plane.number == number; });
    if (grown == stage.planes.end()) continue;
    const Point2 at = on_disc(grown->peak.plane.normal);
    const auto near = std::find_if(rings.begin(), rings.end(), [&](const Ring& ring) {
      return std::hypot(ring.at.x - at.x, ring.at.y - at.y) < ring_radius;
    });
    if (near == rings.end()) {
      rings.push_back({at, std::to_string(number)});
    } else {
      near->numbers.append(" ").append(std::to_string(number));
    }
  }
  return rings;
}

void draw_peaks(const HoughStage& stage, Image<Rgb>& picture) {
  for (const Ring& ring : rings_of(stage)) {
    draw_circle(picture, ring.at, ring_radius, {marker_colour, 2, 1});
    const double right = ring.at.x + ring_radius + 6 + text_size(ring.numbers, 2).width / 2.0;
    draw_tag(picture, ring.numbers, {right, ring.at.y}, {.scale = 2, .colour = ink});
  }
}

Rgb patch_colour(const HoughStage& stage, const HoughPatch& patch) {
  if (patch.candidate == 0) return bare_colour;
  const std::uint16_t number = stage.planes[patch.candidate - 1U].number;
  return number != 0 ? plane_colour(number) : rival_colour;
}

}  // namespace

Image<Rgb> show_patches(const ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  const int zoom = zoom_of(size);
  Image<Rgb> picture = paint(size, zoom, [&](std::int32_t x, std::int32_t y) {
    return run.depth.raw.at(x, y) == 0 ? hole_colour : free_colour_of_readings;
  });
  for (const HoughPatch& patch : run.hough.search.patches()) {
    const std::int32_t x1 = std::min(patch.x + patch.side, size.width) * zoom;
    const std::int32_t y1 = std::min(patch.y + patch.side, size.height) * zoom;
    const Rgb colour = patch_colour(run.hough, patch);
    for (std::int32_t y = patch.y * zoom; y < y1; ++y) {
      for (std::int32_t x = patch.x * zoom; x < x1; ++x) {
        const bool rim = x == patch.x * zoom || y == patch.y * zoom;
        const bool crossed = !patch.votes && (x - y) % 6 == 0;
        picture.at(x, y) = rim || crossed ? mix(colour, ink, 0.6) : colour;
      }
    }
  }
  return picture;
}

SpherePicture show_sphere(const ExplainDepthRun& run) {
  const HoughAccumulator& accumulator = run.hough.search.accumulator();
  const std::vector<std::uint32_t> best = best_of_directions(accumulator);
  SpherePicture out;
  // Without a voter the accumulator was never cleared.
  if (run.hough.result.votes > 0) out.most_votes = *std::max_element(best.begin(), best.end());
  const double whole = std::max(out.most_votes, 1U);
  out.picture = Image<Rgb>(Size{disc + 2 * border, disc + 2 * border}, paper);
  for (std::int32_t y = 0; y < out.picture.height(); ++y) {
    for (std::int32_t x = 0; x < out.picture.width(); ++x) {
      Vector3 n;
      if (!from_disc(x + 0.5, y + 0.5, n)) continue;
      const auto cell = static_cast<std::size_t>(accumulator.directions().cell(n));
      out.picture.at(x, y) = heat(out.most_votes > 0 ? std::cbrt(best[cell] / whole) : 0);
    }
  }
  draw_rings(out.picture);
  draw_peaks(run.hough, out.picture);
  return out;
}

Image<Rgb> show_distances(const ExplainDepthRun& run) {
  const HoughAccumulator& accumulator = run.hough.search.accumulator();
  std::vector<const GrownPlane*> rows(std::min(run.candidates.size(), shown_planes));
  for (const GrownPlane& grown : run.hough.planes) {
    if (grown.number > 0 && grown.number <= rows.size()) rows[grown.number - 1U] = &grown;
  }
  constexpr std::int32_t row_height = 26;
  const auto count = static_cast<std::int32_t>(rows.size());
  const double farthest = accumulator.distance_of(accumulator.distances() - 1) + accumulator.step_m() / 2;
  Chart chart({720, std::max(count, 1) * row_height}, {0, farthest, "distance (m)"}, {0, 0, "candidate"});
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t top = Chart::top + i * row_height;
    draw_text(chart.picture().view(), std::to_string(i + 1),
              {.x = Chart::left - 34, .y = top + 6, .scale = 2, .colour = ink});
    const GrownPlane* grown = rows[static_cast<std::size_t>(i)];
    if (grown == nullptr) continue;
    const std::int32_t direction = accumulator.directions().cell(grown->peak.plane.normal);
    const double whole = std::max(grown->peak.votes, 1U);
    for (std::int32_t x = 0; x < chart.body().width; ++x) {
      const std::int32_t k = x * accumulator.distances() / chart.body().width;
      const Rgb colour = heat(std::sqrt(accumulator.votes(direction, k) / whole));
      for (std::int32_t y = top + 2; y < top + row_height; ++y)
        chart.picture().at(Chart::left + x, y) = colour;
    }
  }
  return std::move(chart.picture());
}

}  // namespace straightedge::cli
