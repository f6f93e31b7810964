// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_ransac.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cli/explain_chart.hpp"
#include "cli/explain_colours.hpp"
#include "cli/explain_depth_pictures.hpp"
#include "cli/explain_paint.hpp"
#include "straightedge/host/draw.hpp"
#include "straightedge/host/label_picture.hpp"

namespace straightedge::cli {
namespace {

constexpr Rgb inlier_colour{0x2F, 0x9E, 0x6E};
constexpr Size chart_body{720, 300};

void draw_box(Image<Rgb>& picture, Point2 a, Point2 b, const Stroke& stroke) {
  draw_line(picture.view(), a, {b.x, a.y}, stroke);
  draw_line(picture.view(), {b.x, a.y}, b, stroke);
  draw_line(picture.view(), b, {a.x, b.y}, stroke);
  draw_line(picture.view(), {a.x, b.y}, a, stroke);
}

void draw_dot(Image<Rgb>& picture, Point2 at, double width, Rgb colour) {
  draw_line(picture.view(), at, at, {colour, width, 1});
}

struct PixelReading {
  std::int32_t x = 0, y = 0;
  double q = 0;
};

/// Pixels of the frame.
PixelReading reading_of(const ExplainDepthRun& run, std::uint32_t pixel) {
  const WatchedWindow& window = *run.ransac.window;
  const auto width = static_cast<std::uint32_t>(window.side_u);
  PixelReading reading{window.x + static_cast<std::int32_t>(pixel % width),
                       window.y + static_cast<std::int32_t>(pixel / width), 0};
  reading.q = static_cast<double>(run.inverse_depth.at(reading.x, reading.y));
  return reading;
}

InverseDepthPlane plane_through(const PixelReading& a, const PixelReading& b, const PixelReading& c) {
  const double bu = b.x - a.x, bv = b.y - a.y, cu = c.x - a.x, cv = c.y - a.y;
  const double area = bu * cv - cu * bv;
  if (area == 0) return {};
  InverseDepthPlane plane;
  plane.a = ((b.q - a.q) * cv - (c.q - a.q) * bv) / area;
  plane.b = (bu * (c.q - a.q) - cu * (b.q - a.q)) / area;
  plane.c = a.q - plane.a * a.x - plane.b * a.y;
  return plane;
}

/// Depth as a pale picture on which marks stand out.
Rgb pale_depth(const ExplainDepthRun& run, const DepthRange& range, std::int32_t x, std::int32_t y) {
  const std::uint16_t raw = run.depth.raw.at(x, y);
  if (raw == 0) return hole_colour;
  const double z = raw * run.depth.metres_per_unit;
  const double share =
      range.farthest > range.nearest ? (z - range.nearest) / (range.farthest - range.nearest) : 0;
  return mix(depth_colour(share), paper, 0.55);
}

/// How far the reading is from the plane, in gates; negative without a reading. Pixels of the frame.
double distance_in_gates(const ExplainDepthRun& run, const InverseDepthPlane& plane, std::int32_t x,
                         std::int32_t y) {
  const PlaneGate gate = widened(run.options.frame);
  const auto q = static_cast<double>(run.inverse_depth.at(x, y));
  return q > 0 ? std::abs(plane.at(x, y) - q) / (gate.sigmas * gate.inverse_noise(q)) : -1;
}

/// MSAC's cost of the refitted plane for a reading of the window.
double mean_cost(const ExplainDepthRun& run, const WatchedWindow& w) {
  double sum = 0, readings = 0;
  for (std::int32_t y = w.y; y < w.y + w.side_v; ++y) {
    for (std::int32_t x = w.x; x < w.x + w.side_u; ++x) {
      const double away = distance_in_gates(run, w.refitted, x, y);
      if (away < 0) continue;
      sum += std::min(1.0, away * away);
      readings += 1;
    }
  }
  return readings > 0 ? sum / readings : 0;
}

/// The window, with what lies near a plane.
TriplePicture show_near(const ExplainDepthRun& run, const InverseDepthPlane& plane) {
  const WatchedWindow& w = *run.ransac.window;
  const Size size{w.side_u, w.side_v};
  TriplePicture out;
  out.picture = paint(size, zoom_of(size), [&](std::int32_t x, std::int32_t y) {
    const double away = distance_in_gates(run, plane, w.x + x, w.y + y);
    if (away < 0) return hole_colour;
    ++out.readings;
    if (away > 1) return free_colour_of_readings;
    ++out.inliers;
    return mix(inlier_colour, paper, 0.7 * away * away);
  });
  return out;
}

}  // namespace

Image<Rgb> show_window(const ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  const int zoom = zoom_of(size);
  const DepthRange range = depth_range(run);
  const WatchedWindow& w = *run.ransac.window;
  Image<Rgb> picture =
      paint(size, zoom, [&](std::int32_t x, std::int32_t y) { return pale_depth(run, range, x, y); });
  draw_box(picture, {1.0 * w.x * zoom, 1.0 * w.y * zoom},
           {1.0 * (w.x + w.side_u) * zoom, 1.0 * (w.y + w.side_v) * zoom}, {taken_colour, 3, 1});
  return picture;
}

Image<Rgb> show_hypotheses(const ExplainDepthRun& run) {
  const WatchedWindow& window = *run.ransac.window;
  const auto count = static_cast<double>(window.events.size());
  Chart chart(chart_body, {0, count + 1, "hypothesis"}, {0, 1.0 * window.subset, "cost"});
  const double refitted = mean_cost(run, window) * window.subset;
  draw_line(chart.picture().view(), chart.place(0, refitted), chart.place(count + 1, refitted),
            {inlier_colour, 2, 0.9});
  for (const RansacEvent& event : window.events) {
    const Point2 at = chart.place(event.iteration + 1.0, static_cast<double>(event.cost));
    draw_dot(chart.picture(), at, event.best ? 11 : 6, event.best ? taken_colour : waiting_colour);
  }
  return std::move(chart.picture());
}

TriplePicture show_triple(const ExplainDepthRun& run, const RansacEvent& event) {
  const WatchedWindow& w = *run.ransac.window;
  const PixelReading corners[] = {reading_of(run, event.triple[0]), reading_of(run, event.triple[1]),
                                  reading_of(run, event.triple[2])};
  const int zoom = zoom_of({w.side_u, w.side_v});
  TriplePicture out = show_near(run, plane_through(corners[0], corners[1], corners[2]));
  Point2 at[3];
  for (int i = 0; i < 3; ++i) at[i] = {(corners[i].x - w.x + 0.5) * zoom, (corners[i].y - w.y + 0.5) * zoom};
  for (int i = 0; i < 3; ++i) draw_line(out.picture.view(), at[i], at[(i + 1) % 3], {ink, 1.5, 0.7});
  for (const Point2& corner : at) draw_dot(out.picture, corner, 13, paper);
  for (const Point2& corner : at) draw_dot(out.picture, corner, 9, taken_colour);
  return out;
}

TriplePicture show_refitted(const ExplainDepthRun& run) {
  return show_near(run, run.ransac.window->refitted);
}

std::vector<RansacEvent> best_events(const WatchedWindow& window) {
  std::vector<RansacEvent> best;
  std::copy_if(window.events.begin(), window.events.end(), std::back_inserter(best),
               [](const RansacEvent& event) { return event.best; });
  return best;
}

Image<Rgb> show_boxes(const ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  const int zoom = zoom_of(size);
  const DepthRange range = depth_range(run);
  Image<Rgb> picture = paint(size, zoom, [&](std::int32_t x, std::int32_t y) {
    const Rgb base = pale_depth(run, range, x, y);
    const std::uint16_t candidate = run.nearest.at(x, y);
    return candidate == 0 || candidate > shown_boxes ? base : mix(base, plane_colour(candidate), 0.35);
  });
  const double scale = zoom;
  for (std::size_t k = std::min(run.ransac.candidates.size(), shown_boxes); k-- > 0;) {
    const ProposedPlane& c = run.ransac.candidates[k];
    draw_box(picture, {c.column0 * scale, c.row0 * scale},
             {std::min(c.column1 * scale, 1.0 * picture.width()),
              std::min(c.row1 * scale, 1.0 * picture.height())},
             {plane_colour(static_cast<std::uint32_t>(k + 1)), c.rough ? 1.2 : 2.6, 1});
  }
  draw_numbers(picture, run.nearest, zoom, shown_boxes);
  return picture;
}

}  // namespace straightedge::cli
