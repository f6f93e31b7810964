// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/hole_bridges.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace straightedge {
namespace {

/// The corners that belong to an outer border or to a hole that is joined with one.
using Joined = std::vector<std::uint32_t>;

void append_ring(const Borders& borders, std::uint32_t first, Joined& joined) {
  std::uint32_t corner = first;
  do {
    joined.push_back(corner);
    corner = borders.corners[corner].after;
  } while (corner != first);
}

std::uint32_t leftmost(const Borders& borders, std::uint32_t first) {
  std::uint32_t best = first;
  for (std::uint32_t corner = borders.corners[first].after; corner != first;
       corner = borders.corners[corner].after) {
    const GridPoint& a = borders.at(corner);
    const GridPoint& b = borders.at(best);
    if (a.x < b.x || (a.x == b.x && a.y < b.y)) best = corner;
  }
  return best;
}

/// An edge by its first corner, and where a level line meets it.
struct SeenEdge {
  std::uint32_t corner = 0;
  double x = 0;
};

// Only edges that run downwards have the area on their right side in the picture.
std::optional<SeenEdge> edge_to_the_left(const Borders& borders, const Joined& joined, const GridPoint& p) {
  std::optional<SeenEdge> nearest;
  for (const std::uint32_t corner : joined) {
    const GridPoint& s = borders.at(corner);
    const GridPoint& t = borders.after(corner);
    if (s.y < p.y || t.y > p.y || s.y == t.y || turn(s, t, p) < 0) continue;
    const double x = static_cast<double>(s.x) +
                     static_cast<double>((t.x - s.x) * (s.y - p.y)) / static_cast<double>(s.y - t.y);
    if (!nearest || x > nearest->x) nearest = SeenEdge{corner, x};
  }
  return nearest;
}

/// Whether `a` is nearer in direction to straight left of p than `b`, or as near and nearer by. Both lie to
/// the left of p or in its column.
bool is_nearer(const GridPoint& p, const GridPoint& a, const GridPoint& b) {
  const std::int64_t ax = p.x - a.x, ay = std::abs(a.y - p.y);
  const std::int64_t bx = p.x - b.x, by = std::abs(b.y - p.y);
  const std::int64_t difference = ay * bx - by * ax;
  return difference != 0 ? difference < 0 : ax + ay < bx + by;
}

std::uint32_t visible_corner(const Borders& borders, const Joined& joined, const GridPoint& p,
                             std::uint32_t edge) {
  const std::uint32_t end = borders.corners[edge].after;
  const GridPoint& s = borders.at(edge);
  const GridPoint& t = borders.at(end);
  if (s.y == p.y) return edge;
  if (t.y == p.y) return end;
  std::uint32_t best = s.x < t.x ? edge : end;
  const GridPoint m = borders.at(best);
  const std::int64_t up = m.y > p.y ? 1 : -1;
  for (const std::uint32_t corner : joined) {
    const GridPoint& r = borders.at(corner);
    const std::int64_t height = up * (r.y - p.y);
    if (height < 0 || height > up * (m.y - p.y)) continue;
    if (turn(s, t, r) < 0 || up * turn(p, m, r) < 0) continue;
    if (is_nearer(p, r, borders.at(best))) best = corner;
  }
  return best;
}

/// Whether the way from the corner to p begins in the area.
bool lies_in_angle(const Borders& borders, std::uint32_t corner, const GridPoint& p) {
  const GridPoint& at = borders.at(corner);
  const bool left_of_arrival = turn(borders.before(corner), at, p) >= 0;
  const bool left_of_departure = turn(at, borders.after(corner), p) >= 0;
  return borders.turn_at(corner) > 0 ? left_of_arrival && left_of_departure
                                     : left_of_arrival || left_of_departure;
}

std::uint32_t corner_with_angle(const Borders& borders, const Joined& joined, std::uint32_t seen,
                                const GridPoint& p) {
  for (const std::uint32_t corner : joined) {
    if (borders.at(corner) == borders.at(seen) && lies_in_angle(borders, corner, p)) return corner;
  }
  return seen;
}

/// ... before, corner, hole, around the hole, hole again, corner again, after ...
void join(Borders& borders, std::uint32_t corner, std::uint32_t hole, Joined& joined) {
  append_ring(borders, hole, joined);
  const auto again = static_cast<std::uint32_t>(borders.corners.size());
  const Corner copies[] = {borders.corners[corner], borders.corners[hole]};
  borders.corners.insert(borders.corners.end(), std::begin(copies), std::end(copies));
  borders.link(again, copies[0].after);
  borders.link(copies[1].before, again + 1);
  borders.link(again + 1, again);
  borders.link(corner, hole);
  joined.push_back(again);
  joined.push_back(again + 1);
}

}  // namespace

void bridge_holes(Borders& borders) {
  Joined joined;
  for (const std::uint32_t outer : borders.outer) append_ring(borders, outer, joined);
  for (std::uint32_t& hole : borders.holes) hole = leftmost(borders, hole);
  std::sort(borders.holes.begin(), borders.holes.end(), [&](std::uint32_t a, std::uint32_t b) {
    const GridPoint& p = borders.at(a);
    const GridPoint& q = borders.at(b);
    return std::pair(p.x, p.y) != std::pair(q.x, q.y) ? std::pair(p.x, p.y) < std::pair(q.x, q.y) : a < b;
  });
  for (const std::uint32_t hole : borders.holes) {
    const GridPoint p = borders.at(hole);
    const auto edge = edge_to_the_left(borders, joined, p);  // Step 1
    if (!edge) continue;
    const std::uint32_t seen = visible_corner(borders, joined, p, edge->corner);  // Step 2
    join(borders, corner_with_angle(borders, joined, seen, p), hole, joined);     // Steps 3 and 4
  }
}

}  // namespace straightedge
