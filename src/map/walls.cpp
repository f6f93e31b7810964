// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/walls.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "map/line_grid.hpp"

namespace straightedge {
namespace {

constexpr double cos_parallel = 0.985;  // 10 degrees
// Blur moves the edges of a thin wall apart by up to this many pixels.
constexpr double blur_spread = 3.0;
// Across a wall, two a pixel: no wall is asked for that is wider than 50 pixels.
constexpr std::size_t most_depths = 128;

/// Where b runs beside a, along a.
Span beside(const WallLine& a, const WallLine& b) {
  const Span other = a.span_of(b);
  return {std::max(a.begin, other.begin), std::min(a.end, other.end)};
}

/// How far b lies on the dark side of a, at a place s along a.
double dark_distance(const WallLine& a, const WallLine& b, double s) {
  const double facing = a.nx * b.nx + a.ny * b.ny;
  return b.across(a.x_at(s), a.y_at(s)) / facing;
}

/// Step 1.
bool opposite(const WallLine& a, const WallLine& b, double max_distance) {
  if (a.axis || b.axis || a.nx * b.nx + a.ny * b.ny > -cos_parallel) return false;
  const Span both = beside(a, b);
  if (both.length() < std::min(4.0, 0.5 * b.length())) return false;
  const double d0 = dark_distance(a, b, both.begin);
  const double d1 = dark_distance(a, b, both.end);
  return std::min(d0, d1) > 0 && std::max(d0, d1) < max_distance + 1 && 0.5 * (d0 + d1) < max_distance;
}

/// Step 2: mean over the stretch of the darkness across the wall, in pixels of black.
double wall_width(const LineSampler& picture, const WallLine& a, Span stretch, double distance) {
  constexpr double step = 0.5;
  constexpr double places = 4;
  const double reach = 0.5 * distance + 2.5;
  std::array<double, most_depths> all_depths, all_grays;
  std::size_t count = 0;
  for (double depth = -reach - 0.5 * distance; depth <= reach - 0.5 * distance && count < most_depths;
       depth += step)
    all_depths[count++] = depth;
  const std::span<const double> depths = std::span(all_depths).first(count),
                                grays = std::span(all_grays).first(count);
  double sum = 0;
  int rows = 0;
  const double way = std::max(stretch.length() / places, 1.0);
  for (double s = stretch.begin + 0.5 * way; s < stretch.end; s += way) {
    picture.across(a, s, depths, all_grays.data());
    for (const double gray : grays) sum += 255 - gray;
    ++rows;
  }
  return rows > 0 ? step * sum / 255 / rows : 0;
}

void add_side(const WallLine& side, double move, double about_x, double about_y, LineMoments& sums) {
  // Moving points by a vector is looking at them from an origin moved the other way.
  const double ox = about_x - side.origin_x - move * side.nx;
  const double oy = about_y - side.origin_y - move * side.ny;
  sums.add(side.moments.seen_from(ox, oy));
}

/// The part of a face that an axis does not stand for, if there is one worth keeping: the longer end.
bool left_over(const WallLine& axis, WallLine& face) {
  const Span gone = face.span_of(axis);
  const double before = gone.begin - face.begin, after = face.end - gone.end;
  if (std::max(before, after) < 8) return false;
  if (before > after) {
    face.end = gone.begin;
  } else {
    face.begin = gone.end;
  }
  return true;
}

/// The sides of one wall that lie opposite to an edge, and what was measured on them.
struct Opposites {
  std::vector<std::size_t> sides;
  double distance = 0;  ///< means, weighted by the common length
  double width = 0;
  double length = 0;  ///< of the wall that has two sides
};

Opposites find_opposites(const std::vector<WallLine>& lines, std::size_t i, LineGrid& grid,
                         const std::vector<bool>& used, const LineSampler& picture, double max_width) {
  Opposites found;
  for (const std::uint32_t j : grid.near(lines[i])) {
    if (j == i || used[j] || !opposite(lines[i], lines[j], max_width + blur_spread)) continue;
    const Span both = beside(lines[i], lines[j]);
    const double distance =
        0.5 * (dark_distance(lines[i], lines[j], both.begin) + dark_distance(lines[i], lines[j], both.end));
    const double width = wall_width(picture, lines[i], both, distance);
    if (width > max_width) continue;
    found.sides.push_back(j);
    found.distance += distance * both.length();
    found.width += width * both.length();
    found.length += both.length();
  }
  if (found.length > 0) {
    found.distance /= found.length;
    found.width /= found.length;
  }
  return found;
}

/// Step 3.
WallLine axis_of(const std::vector<WallLine>& lines, std::size_t i, const Opposites& found) {
  const WallLine& a = lines[i];
  const double half = 0.5 * found.distance;
  WallLine axis = a;
  LineMoments sums;
  add_side(a, -half, a.origin_x, a.origin_y, sums);
  for (const std::size_t j : found.sides) {
    const WallLine& b = lines[j];
    add_side(b, -half, a.origin_x, a.origin_y, sums);
    axis.pixels += b.pixels;
    axis.votes += b.votes;
    axis.count += b.count;
    for (const double s : {b.begin, b.end}) {
      const double t = a.along(b.x_at(s), b.y_at(s));
      axis.begin = std::min(axis.begin, t);
      axis.end = std::max(axis.end, t);
    }
  }
  axis.fit.centroid_x -= half * a.nx;
  axis.fit.centroid_y -= half * a.ny;
  axis.adopt(sums, a.origin_x, a.origin_y);
  axis.axis = true;
  axis.width = found.width;
  return axis;
}

/// Whether an axis stands for the face, so that nothing is left of it; what an axis leaves is cut off.
bool is_absorbed(const std::vector<WallLine>& axes, LineGrid& grid, WallLine& face, double max_distance) {
  for (const std::uint32_t k : grid.near(face)) {
    const WallLine& axis = axes[k];
    const double facing = face.nx * axis.nx + face.ny * axis.ny;
    if (facing * facing < cos_parallel * cos_parallel) continue;
    if (beside(axis, face).length() < 0.5 * face.length()) continue;
    const double middle = 0.5 * (face.begin + face.end);
    const double off = axis.across(face.x_at(middle), face.y_at(middle));
    if (off * off <= 0.25 * max_distance * max_distance && !left_over(axis, face)) return true;
  }
  return false;
}

}  // namespace

std::uint32_t join_thin_walls(std::vector<WallLine>& lines, const LineSampler& picture, double max_width) {
  const double max_distance = max_width + blur_spread;
  sort_longest_first(lines);
  LineGrid grid(lines, max_distance);
  std::vector<bool> used(lines.size(), false);
  std::vector<WallLine> axes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    const Opposites found = find_opposites(lines, i, grid, used, picture, max_width);  // Steps 1 and 2
    if (found.length < 0.3 * lines[i].length() || found.sides.empty()) continue;
    used[i] = true;
    for (const std::size_t j : found.sides) used[j] = true;
    axes.push_back(axis_of(lines, i, found));  // Step 3
  }
  LineGrid axis_grid(axes, max_distance);
  std::vector<WallLine> out = axes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!used[i] && !is_absorbed(axes, axis_grid, lines[i], max_distance)) out.push_back(lines[i]);
  }
  lines = std::move(out);
  return static_cast<std::uint32_t>(axes.size());
}

}  // namespace straightedge
