// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_accumulator.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/explain_colours.hpp"
#include "cli/explain_text.hpp"
#include "straightedge/host/line_geometry.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t left = 92, right = 28, top = 44, bottom = 58;
constexpr std::int32_t body_width = 720, body_height = 480;
constexpr double ring_radius = 8;

/// The distances that a line through the picture can have, and their place in the body.
struct RhoAxis {
  double lowest = 0;
  double highest = 1;

  explicit RhoAxis(Size size)
      : lowest(-1.0 * size.width), highest(std::ceil(std::hypot(size.width, size.height))) {}
  double rho_at(double y) const { return highest - (highest - lowest) * y / body_height; }
  double y_of(double rho) const { return (highest - rho) / (highest - lowest) * body_height; }
};

/// Cells first to last fall on one dot; always at least one.
struct CellRange {
  std::int32_t first, last;
  CellRange(double from, double to, std::int32_t count)
      : first(std::clamp(static_cast<std::int32_t>(std::floor(from)), 0, count - 1)),
        last(std::clamp(static_cast<std::int32_t>(std::ceil(to)) - 1, first, count - 1)) {}
};

std::int32_t best_of(const HoughVotesView& cells, CellRange angles, CellRange distances) {
  std::int32_t best = 0;
  for (std::int32_t n = angles.first; n <= angles.last; ++n) {
    for (std::int32_t r = distances.first; r <= distances.last; ++r) best = std::max(best, cells.at(r, n));
  }
  return best;
}

std::int32_t most_votes(const HoughVotesView& cells) {
  return best_of(cells, {0, 1.0 * cells.height, cells.height}, {0, 1.0 * cells.width, cells.width});
}

void draw_body(const ExplainRun& run, const RhoAxis& axis, std::int32_t most, Image<Rgb>& picture) {
  const HoughVotesView cells = run.votes.accumulator();
  const auto step = static_cast<double>(run.votes.grid().rho_step);
  const double middle = (cells.width - 1) / 2 + 0.5;
  const double whole = std::max(most, 1);
  for (std::int32_t y = 0; y < body_height; ++y) {
    const CellRange distances(axis.rho_at(y + 1) / step + middle, axis.rho_at(y) / step + middle,
                              cells.width);
    for (std::int32_t x = 0; x < body_width; ++x) {
      const double scale = 1.0 * cells.height / body_width;
      const std::int32_t votes = best_of(cells, {x * scale, (x + 1) * scale, cells.height}, distances);
      picture.at(left + x, top + y) = heat(std::sqrt(votes / whole));
    }
  }
}

void draw_tick(Image<Rgb>& picture, std::int32_t x, std::int32_t y, Size extent) {
  for (std::int32_t v = y; v < y + extent.height; ++v) {
    for (std::int32_t u = x; u < x + extent.width; ++u) picture.at(u, v) = ink;
  }
}

/// A step of 1, 2 or 5 times a power of ten that gives about six ticks.
double tick_step(double range) {
  const double rough = range / 6;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return std::max(1.0, factor * power);
  }
  return std::max(1.0, 10 * power);
}

void draw_axes(const RhoAxis& axis, Image<Rgb>& picture) {
  const auto write = [&picture](const std::string& text, std::int32_t x, std::int32_t y) {
    draw_text(picture.view(), text, {.x = x, .y = y, .scale = 2, .colour = ink});
  };
  for (int degrees = 0; degrees <= 180; degrees += 30) {
    const std::int32_t x = left + degrees * body_width / 180;
    draw_tick(picture, std::min(x, left + body_width - 1), top + body_height, {2, 7});
    const std::string text = std::to_string(degrees);
    write(text, x - text_size(text, 2).width / 2, top + body_height + 11);
  }
  const std::string theta = "theta (degrees)";
  write(theta, left + (body_width - text_size(theta, 2).width) / 2, top + body_height + 34);
  const double step = tick_step(axis.highest - axis.lowest);
  for (double rho = std::ceil(axis.lowest / step) * step; rho <= axis.highest; rho += step) {
    const auto y = static_cast<std::int32_t>(axis.y_of(rho));
    draw_tick(picture, left - 7, top + std::min(y, body_height - 1), {7, 2});
    const std::string text = std::to_string(std::lround(rho));
    write(text, left - 12 - text_size(text, 2).width, top + y - 6);
  }
  write("rho (pixels)", 8, 14);
}

void draw_ring(Image<Rgb>& picture, double x, double y) {
  const auto reach = static_cast<std::int32_t>(ring_radius) + 2;
  const auto u0 = static_cast<std::int32_t>(x), v0 = static_cast<std::int32_t>(y);
  for (std::int32_t v = v0 - reach; v <= v0 + reach; ++v) {
    for (std::int32_t u = u0 - reach; u <= u0 + reach; ++u) {
      if (!picture.view().contains(u, v)) continue;
      const double off = std::abs(std::hypot(u + 0.5 - x, v + 0.5 - y) - ring_radius);
      picture.at(u, v) = mix(picture.at(u, v), marker_colour, 1.5 - off);
    }
  }
}

/// A rectangle of the picture.
struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool meets(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

Box box_around(Point2 middle, double width, double height) {
  return {middle.x - width / 2, middle.y - height / 2, middle.x + width / 2, middle.y + height / 2};
}

/// A free place for a label near a point: right, left, below and above, then farther away.
Box free_place(Point2 point, Size label, const std::vector<Box>& taken) {
  Box place;
  for (const double away : {1.0, 2.2, 3.4, 4.6}) {
    const double across = away * (ring_radius + 3) + label.width / 2.0;
    const double down = away * (ring_radius + 3) + label.height / 2.0;
    for (const Point2 step : {Point2{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
      place = box_around({point.x + step.x * across, point.y + step.y * down}, label.width + 4.0,
                         label.height + 4.0);
      const bool inside = place.x0 >= left && place.x1 <= left + body_width && place.y0 >= top &&
                          place.y1 <= top + body_height;
      if (inside &&
          std::none_of(taken.begin(), taken.end(), [&](const Box& box) { return box.meets(place); }))
        return place;
    }
  }
  return place;
}

void draw_peaks(const ExplainRun& run, const RhoAxis& axis, Image<Rgb>& picture) {
  const HoughGrid& grid = run.votes.grid();
  std::vector<Point2> places;
  std::vector<Box> taken;
  for (const HoughPeak& peak : run.peaks) {
    const double row = static_cast<double>(peak.theta) / static_cast<double>(grid.theta_step);
    places.push_back(
        {left + (row + 0.5) / grid.angles * body_width, top + axis.y_of(static_cast<double>(peak.rho))});
    taken.push_back(box_around(places.back(), 2 * ring_radius + 2, 2 * ring_radius + 2));
    draw_ring(picture, places.back().x, places.back().y);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string text = std::to_string(i + 1);
    const Box place = free_place(places[i], text_size(text, 2), taken);
    taken.push_back(place);
    draw_text(picture.view(), text,
              {.x = static_cast<std::int32_t>(place.x0) + 2,
               .y = static_cast<std::int32_t>(place.y0) + 2,
               .scale = 2,
               .colour = marker_colour});
  }
}

}  // namespace

AccumulatorPicture show_accumulator(const ExplainRun& run) {
  AccumulatorPicture out;
  out.picture = Image<Rgb>(Size{left + body_width + right, top + body_height + bottom}, paper);
  out.most_votes = most_votes(run.votes.accumulator());
  const RhoAxis axis(run.edges.size());
  draw_body(run, axis, out.most_votes, out.picture);
  draw_axes(axis, out.picture);
  draw_peaks(run, axis, out.picture);
  return out;
}

}  // namespace straightedge::cli
