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

Image<Rgb> show_hypotheses(const WatchedWindow& window) {
  const auto count = static_cast<double>(window.events.size());
  Chart chart(chart_body, {0, count + 1, "hypothesis"}, {0, 1.0 * window.subset, "cost"});
  for (const RansacEvent& event : window.events) {
    const Point2 at = chart.place(event.iteration + 1.0, static_cast<double>(event.cost));
    draw_dot(chart.picture(), at, event.best ? 9 : 5, event.best ? taken_colour : waiting_colour);
  }
  const std::vector<RansacEvent> best = best_events(window);
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double until = i + 1 < best.size() ? best[i + 1].iteration + 1.0 : count;
    const auto cost = static_cast<double>(best[i].cost);
    draw_line(chart.picture().view(), chart.place(best[i].iteration + 1.0, cost), chart.place(until, cost),
              {taken_colour, 1.6, 0.8});
  }
  return std::move(chart.picture());
}

TriplePicture show_triple(const ExplainDepthRun& run, const RansacEvent& event) {
  const WatchedWindow& w = *run.ransac.window;
  const PlaneGate gate = widened(run.options.frame);
  const PixelReading corners[] = {reading_of(run, event.triple[0]), reading_of(run, event.triple[1]),
                                  reading_of(run, event.triple[2])};
  const InverseDepthPlane plane = plane_through(corners[0], corners[1], corners[2]);
  const Size size{w.side_u, w.side_v};
  const int zoom = zoom_of(size);
  TriplePicture out;
  out.picture = paint(size, zoom, [&](std::int32_t x, std::int32_t y) {
    const auto q = static_cast<double>(run.inverse_depth.at(w.x + x, w.y + y));
    if (!(q > 0)) return hole_colour;
    ++out.readings;
    const double share = std::abs(plane.at(w.x + x, w.y + y) - q) / (gate.sigmas * gate.inverse_noise(q));
    if (share > 1) return free_colour_of_readings;
    ++out.inliers;
    return mix(inlier_colour, paper, 0.7 * share * share);
  });
  Point2 at[3];
  for (int i = 0; i < 3; ++i) at[i] = {(corners[i].x - w.x + 0.5) * zoom, (corners[i].y - w.y + 0.5) * zoom};
  for (int i = 0; i < 3; ++i) draw_line(out.picture.view(), at[i], at[(i + 1) % 3], {ink, 1.5, 0.7});
  for (const Point2& corner : at) draw_dot(out.picture, corner, 13, paper);
  for (const Point2& corner : at) draw_dot(out.picture, corner, 9, taken_colour);
  return out;
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
    return candidate == 0 ? base : mix(base, plane_colour(candidate), 0.35);
  });
  const double cell = 1.0 * run.options.ransac.cell * zoom;
  for (std::size_t k = run.ransac.candidates.size(); k-- > 0;) {
    const PlaneCandidate& c = run.ransac.candidates[k];
    draw_box(
        picture, {c.column0 * cell, c.row0 * cell},
        {std::min(c.column1 * cell, 1.0 * picture.width()), std::min(c.row1 * cell, 1.0 * picture.height())},
        {plane_colour(static_cast<std::uint32_t>(k + 1)), c.rough ? 1.2 : 2.6, 1});
  }
  draw_numbers(picture, run.nearest, zoom);
  return picture;
}

}  // namespace straightedge::cli
