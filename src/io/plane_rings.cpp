// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_rings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/svg_canvas.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {
namespace {

double squared_distance(Point2 p, Point2 a, Point2 b) {
  const Point2 along{b.x - a.x, b.y - a.y};
  const Point2 from_a{p.x - a.x, p.y - a.y};
  const double squared = dot(along, along);
  const double at = squared > 0 ? std::clamp(dot(from_a, along) / squared, 0.0, 1.0) : 0.0;
  const Point2 rest{from_a.x - at * along.x, from_a.y - at * along.y};
  return dot(rest, rest);
}

/// Calls action(a, b) for each edge.
template <class Action>
void for_each_edge(const Ring& ring, Action&& action) {
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++)
    action(ring[before], ring[i]);
}

double distance_to_borders(Point2 point, const std::vector<Ring>& rings) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rings) {
    for_each_edge(ring, [&](Point2 a, Point2 b) { least = std::min(least, squared_distance(point, a, b)); });
  }
  return std::sqrt(least);
}

Bounds bounds_of(const Ring& ring) {
  Bounds bounds;
  for (const Point2 p : ring) bounds.include(p);
  return bounds;
}

struct Place {
  Point2 point;
  double value = -std::numeric_limits<double>::infinity();
};

/// Keeps the better place of what it had and a grid of cells x cells over the box.
void search_grid(const std::vector<Ring>& rings, Point2 middle, const Bounds& box, int cells, Place& best) {
  constexpr double pull = 0.2;  // metres of room given up for a metre nearer to the middle
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const Point2 p{box.left + (column + 0.5) / cells * (box.right - box.left),
                     box.bottom + (row + 0.5) / cells * (box.top - box.bottom)};
      if (!inside(p, rings)) continue;
      const Point2 aside{p.x - middle.x, p.y - middle.y};
      const double away = std::sqrt(dot(aside, aside));
      const double value = distance_to_borders(p, rings) - pull * away;
      if (value > best.value) best = {p, value};
    }
  }
}

}  // namespace

double signed_area(const Ring& ring) {
  if (ring.empty()) return 0;
  const Point2 origin = ring.front();
  double twice = 0;
  for_each_edge(ring, [&](Point2 a, Point2 b) {
    twice += (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
  });
  return 0.5 * twice;
}

Point2 centroid(const Ring& ring) {
  if (ring.empty()) return {};
  const Point2 origin = ring.front();
  double twice = 0;
  Point2 weighted, sum;
  for_each_edge(ring, [&](Point2 a, Point2 b) {
    a = {a.x - origin.x, a.y - origin.y};
    b = {b.x - origin.x, b.y - origin.y};
    const double part = a.x * b.y - a.y * b.x;
    twice += part;
    weighted = {weighted.x + part * (a.x + b.x), weighted.y + part * (a.y + b.y)};
    sum = {sum.x + b.x, sum.y + b.y};
  });
  const Bounds box = bounds_of(ring);
  const double size = (box.right - box.left) * (box.top - box.bottom);
  const auto count = static_cast<double>(ring.size());
  if (!(std::abs(twice) > 1e-9 * size)) return {origin.x + sum.x / count, origin.y + sum.y / count};
  return {origin.x + weighted.x / (3 * twice), origin.y + weighted.y / (3 * twice)};
}

bool inside(Point2 point, const std::vector<Ring>& rings) {
  bool odd = false;
  for (const Ring& ring : rings) {
    for_each_edge(ring, [&](Point2 a, Point2 b) {
      if ((a.y > point.y) == (b.y > point.y)) return;
      if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    });
  }
  return odd;
}

Point2 label_place(const std::vector<Ring>& rings) {
  const Point2 middle = centroid(rings.front());
  Bounds box = bounds_of(rings.front());
  Place best;
  // An odd grid round the middle has the middle itself as a candidate.
  search_grid(rings, middle, {middle.x, middle.y, middle.x, middle.y}, 1, best);
  for (const int cells : {9, 5, 5}) {
    search_grid(rings, middle, box, cells, best);
    if (!(best.value > -std::numeric_limits<double>::infinity())) return middle;
    const double half_width = (box.right - box.left) / cells;
    const double half_height = (box.top - box.bottom) / cells;
    box = {best.point.x - half_width, best.point.y - half_height, best.point.x + half_width,
           best.point.y + half_height};
  }
  return best.point;
}

Point2 smallest_rectangle(const std::vector<Ring>& rings) {
  Point2 best;
  double least = std::numeric_limits<double>::infinity();
  for (int degrees = 0; degrees < 90; ++degrees) {
    const SineCosine turn = sine_cosine(degrees * degree);
    Bounds box;
    for (const Ring& ring : rings) {
      for (const Point2 p : ring) {
        box.include({turn.cosine * p.x + turn.sine * p.y, turn.cosine * p.y - turn.sine * p.x});
      }
    }
    if (box.empty()) return {};
    const Point2 sides{box.right - box.left, box.top - box.bottom};
    if (sides.x * sides.y < least) {
      least = sides.x * sides.y;
      best = {std::max(sides.x, sides.y), std::min(sides.x, sides.y)};
    }
  }
  return best;
}

PlaneBasis::PlaneBasis(const Vector3& normal) {
  const Vector3 level = cross({0, 0, 1}, normal);
  u = squared_length(level) > 1e-6 ? normalized(level) : normalized(cross({0, 1, 0}, normal));
  v = cross(normal, u);
}

}  // namespace straightedge::io
