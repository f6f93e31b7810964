// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "map/line_grid.hpp"

namespace straightedge {
namespace {

constexpr double min_sine = 0.342;  // 20 degrees
constexpr double min_bend = 0.1;    // 6 degrees
constexpr double bend_reach = 14;   // pixels; at a slight bend two pieces overlap far

struct Crossing {
  double on_a = 0;  ///< along each line
  double on_b = 0;
  bool bend = false;  ///< the two continue one another round a slight bend
};

bool cross(const WallLine& a, const WallLine& b, Crossing& at) {
  const double sine = a.nx * b.ny - a.ny * b.nx;
  if (std::fabs(sine) < min_bend) return false;
  at.bend = std::fabs(sine) < min_sine;
  const double slope = a.tx() * b.nx + a.ty() * b.ny;  // how fast b's distance changes along a
  at.on_a = -b.across(a.fit.centroid_x, a.fit.centroid_y) / slope;
  at.on_b = b.along(a.x_at(at.on_a), a.y_at(at.on_a));
  return true;
}

/// Whether an end at `s` may move to the crossing.
bool reaches(const WallLine& line, double s, const WallLine& other, const Crossing& at, double reach) {
  const double way = std::fabs(at.on_a - s);
  if (at.bend) {
    const double from_end = std::min(std::fabs(at.on_b - other.begin), std::fabs(at.on_b - other.end));
    return line.axis == other.axis && way <= bend_reach && from_end <= bend_reach && at.on_b > other.begin &&
           at.on_b < other.end && at.on_a > line.begin && at.on_a < line.end;
  }
  const double own = reach + 0.5 * other.width;
  return way <= own && at.on_b >= other.begin - own && at.on_b <= other.end + own;
}

/// Segments that may reach one another.
class Neighbours {
 public:
  Neighbours(const std::vector<WallLine>& lines, const std::vector<WallLine>& helpers, double reach)
      : lines_(lines),
        helpers_(helpers),
        reach_(reach + widest),
        grid_(lines, reach_),
        helper_grid_(helpers, reach_) {}

  /// Of the end at `s` of lines[i].
  const std::vector<const WallLine*>& of(std::size_t i, double s) {
    WallLine around = lines_[i];
    around.begin = s - reach_;
    around.end = s + reach_;
    found_.clear();
    for (const std::uint32_t j : grid_.near(around))
      if (j != i) found_.push_back(&lines_[j]);
    for (const std::uint32_t j : helper_grid_.near(around)) found_.push_back(&helpers_[j]);
    return found_;
  }

 private:
  static constexpr double widest = 10;  // half the width of a thin wall, with room; a bend

  const std::vector<WallLine>& lines_;
  const std::vector<WallLine>& helpers_;
  double reach_;
  LineGrid grid_, helper_grid_;
  std::vector<const WallLine*> found_;
};

/// The place on `line` nearest to its end at `s` where another segment crosses it.
double snapped(const WallLine& line, double s, const std::vector<const WallLine*>& others, double reach) {
  double best = bend_reach + 1;
  double place = s;
  for (const WallLine* other : others) {
    Crossing at;
    if (!cross(line, *other, at) || !reaches(line, s, *other, at, reach)) continue;
    const double way = std::fabs(at.on_a - s);
    if (way >= best) continue;
    best = way;
    place = at.on_a;
  }
  return place;
}

}  // namespace

void close_corners(std::vector<WallLine>& lines, const std::vector<WallLine>& helpers, double reach) {
  Neighbours neighbours(lines, helpers, reach);
  std::vector<WallLine> closed = lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const WallLine& line = lines[i];
    const double begin = snapped(line, line.begin, neighbours.of(i, line.begin), reach);
    const double end = snapped(line, line.end, neighbours.of(i, line.end), reach);
    if (end - begin < 0.5 * line.length()) continue;
    closed[i].begin = begin;
    closed[i].end = end;
  }
  lines = std::move(closed);
}

}  // namespace straightedge
