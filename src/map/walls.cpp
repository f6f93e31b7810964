// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/walls.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "map/sample.hpp"

namespace straightedge {
namespace {

constexpr double cos_parallel = 0.985;  // 10 degrees
// Blur moves the edges of a thin wall apart by up to this many pixels.
constexpr double blur_spread = 3.0;

struct Overlap {
  double begin = 0;
  double end = 0;
  double length() const { return end - begin; }
};

/// Where b runs beside a, along a.
Overlap beside(const WallLine& a, const WallLine& b) {
  const double s0 = a.along(b.x_at(b.begin), b.y_at(b.begin));
  const double s1 = a.along(b.x_at(b.end), b.y_at(b.end));
  return {std::max(a.begin, std::min(s0, s1)), std::min(a.end, std::max(s0, s1))};
}

/// How far b lies on the dark side of a, at a place s along a.
double dark_distance(const WallLine& a, const WallLine& b, double s) {
  const double facing = a.nx * b.nx + a.ny * b.ny;
  return b.across(a.x_at(s), a.y_at(s)) / facing;
}

/// Step 1.
bool opposite(const WallLine& a, const WallLine& b, double max_distance) {
  if (a.axis || b.axis || a.nx * b.nx + a.ny * b.ny > -cos_parallel) return false;
  const Overlap both = beside(a, b);
  if (both.length() < std::min(4.0, 0.5 * b.length())) return false;
  const double d0 = dark_distance(a, b, both.begin);
  const double d1 = dark_distance(a, b, both.end);
  return std::min(d0, d1) > 0 && std::max(d0, d1) < max_distance + 1 && 0.5 * (d0 + d1) < max_distance;
}

/// Step 2: mean over the stretch of the darkness across the wall, in pixels of black.
double wall_width(GrayView picture, const WallLine& a, Overlap stretch, double distance) {
  constexpr double step = 0.25;
  const double reach = 0.5 * distance + 2.5;
  double sum = 0;
  int rows = 0;
  for (double s = stretch.begin; s <= stretch.end; s += 1) {
    for (double u = -reach; u <= reach; u += step) {
      const double depth = u - 0.5 * distance;
      sum += step * (255 - sample(picture, a.x_at(s) + depth * a.nx, a.y_at(s) + depth * a.ny)) / 255;
    }
    ++rows;
  }
  return rows > 0 ? sum / rows : 0;
}

void add_side(const WallLine& side, double move, double about_x, double about_y, LineMoments& sums) {
  // Moving points by a vector is looking at them from an origin moved the other way.
  const double ox = about_x - side.origin_x - move * side.nx;
  const double oy = about_y - side.origin_y - move * side.ny;
  sums.add(side.moments.seen_from(ox, oy));
}

/// Step 3.
WallLine axis_of(const WallLine& a, const std::vector<const WallLine*>& sides, double distance,
                 double width) {
  WallLine axis = a;
  LineMoments sums;
  add_side(a, -0.5 * distance, a.origin_x, a.origin_y, sums);
  const double facing_x = a.nx, facing_y = a.ny;
  for (const WallLine* b : sides) {
    add_side(*b, -0.5 * distance, a.origin_x, a.origin_y, sums);
    axis.pixels += b->pixels;
    axis.votes += b->votes;
    axis.count += b->count;
  }
  double begin = a.begin, end = a.end;
  for (const WallLine* b : sides) {
    for (const double s : {b->begin, b->end}) {
      const double t = a.along(b->x_at(s), b->y_at(s));
      begin = std::min(begin, t);
      end = std::max(end, t);
    }
  }
  axis.begin = begin;
  axis.end = end;
  axis.fit.centroid_x -= 0.5 * distance * facing_x;
  axis.fit.centroid_y -= 0.5 * distance * facing_y;
  axis.adopt(sums, a.origin_x, a.origin_y);
  axis.axis = true;
  axis.width = width;
  return axis;
}

/// The part of a face that an axis does not stand for, if there is one worth keeping: the longer end.
bool left_over(const WallLine& axis, WallLine& face) {
  const double s0 = face.along(axis.x_at(axis.begin), axis.y_at(axis.begin));
  const double s1 = face.along(axis.x_at(axis.end), axis.y_at(axis.end));
  const double lo = std::min(s0, s1), hi = std::max(s0, s1);
  const double before = lo - face.begin, after = face.end - hi;
  if (std::max(before, after) < 8) return false;
  if (before > after) {
    face.end = lo;
  } else {
    face.begin = hi;
  }
  return true;
}

}  // namespace

std::uint32_t join_thin_walls(std::vector<WallLine>& lines, GrayView picture, double max_width) {
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lines[a].length() > lines[b].length(); });
  std::vector<bool> used(lines.size(), false);
  std::vector<WallLine> out;
  const double max_distance = max_width + blur_spread;
  for (const std::size_t i : order) {
    if (used[i]) continue;
    const WallLine& a = lines[i];
    std::vector<const WallLine*> sides;
    std::vector<std::size_t> taken;
    double distance_sum = 0, width_sum = 0, length_sum = 0;
    for (const std::size_t j : order) {
      if (j == i || used[j] || !opposite(a, lines[j], max_distance)) continue;
      const Overlap both = beside(a, lines[j]);
      const double distance =
          0.5 * (dark_distance(a, lines[j], both.begin) + dark_distance(a, lines[j], both.end));
      const double width = wall_width(picture, a, both, distance);
      if (width > max_width) continue;
      sides.push_back(&lines[j]);
      taken.push_back(j);
      distance_sum += distance * both.length();
      width_sum += width * both.length();
      length_sum += both.length();
    }
    if (sides.empty() || length_sum < 0.3 * a.length()) continue;
    used[i] = true;
    for (const std::size_t j : taken) used[j] = true;
    out.push_back(axis_of(a, sides, distance_sum / length_sum, width_sum / length_sum));
  }
  const auto axes = static_cast<std::uint32_t>(out.size());
  for (const std::size_t i : order) {
    if (used[i]) continue;
    bool inside = false;
    for (std::size_t k = 0; k < axes && !inside; ++k) {
      const WallLine& axis = out[k];
      const double facing = lines[i].nx * axis.nx + lines[i].ny * axis.ny;
      if (facing * facing < cos_parallel * cos_parallel) continue;
      const Overlap both = beside(axis, lines[i]);
      if (both.length() < 0.5 * lines[i].length()) continue;
      const double s = 0.5 * (lines[i].begin + lines[i].end);
      const double off = axis.across(lines[i].x_at(s), lines[i].y_at(s));
      if (off * off > max_distance * max_distance / 4) continue;
      inside = !left_over(axis, lines[i]);
    }
    if (!inside) out.push_back(lines[i]);
  }
  lines = std::move(out);
  return axes;
}

}  // namespace straightedge
