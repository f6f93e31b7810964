// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/corners.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "map/line_grid.hpp"

namespace straightedge {
namespace {

constexpr double min_sine = 0.342;  // 20 degrees

struct Crossing {
  double on_a = 0;  ///< along each line
  double on_b = 0;
};

bool cross(const WallLine& a, const WallLine& b, Crossing& at) {
  const double sine = a.nx * b.ny - a.ny * b.nx;
  if (std::fabs(sine) < min_sine) return false;
  const double slope = a.tx() * b.nx + a.ty() * b.ny;  // how fast b's distance changes along a
  at.on_a = -b.across(a.fit.centroid_x, a.fit.centroid_y) / slope;
  at.on_b = b.along(a.x_at(at.on_a), a.y_at(at.on_a));
  return true;
}

/// The place on `line` nearest to its end at `s` where another segment crosses it.
double snapped(const WallLine& line, double s, const std::vector<const WallLine*>& others, double reach) {
  double best = 2 * reach;
  double place = s;
  for (const WallLine* other : others) {
    Crossing at;
    if (!cross(line, *other, at)) continue;
    const double own = reach + 0.5 * other->width;
    if (at.on_b < other->begin - own || at.on_b > other->end + own) continue;
    const double way = std::fabs(at.on_a - s);
    if (way > own || way >= best) continue;
    best = way;
    place = at.on_a;
  }
  return place;
}

}  // namespace

void close_corners(std::vector<WallLine>& lines, const std::vector<WallLine>& helpers, double reach) {
  constexpr double widest = 10;  // half the width of a thin wall, with room
  const LineGrid near_lines(lines, reach + widest);
  const LineGrid near_helpers(helpers, reach + widest);
  std::vector<WallLine> closed = lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<const WallLine*> others;
    for (const std::size_t j : near_lines.near(lines[i])) {
      if (j != i) others.push_back(&lines[j]);
    }
    for (const std::size_t j : near_helpers.near(lines[i])) others.push_back(&helpers[j]);
    const double begin = snapped(lines[i], lines[i].begin, others, reach);
    const double end = snapped(lines[i], lines[i].end, others, reach);
    if (end - begin < 0.5 * lines[i].length()) continue;
    closed[i].begin = begin;
    closed[i].end = end;
  }
  lines = std::move(closed);
}

}  // namespace straightedge
