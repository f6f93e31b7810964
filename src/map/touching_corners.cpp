// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/touching_corners.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace straightedge {
namespace {

std::int64_t cross(const GridPoint& a, const GridPoint& b) {
  return a.x * b.y - a.y * b.x;
}

/// Which part of a clockwise turn from `start` leads to `way`: up to half, half, up to whole, whole.
int part_of_turn(const GridPoint& start, const GridPoint& way) {
  const std::int64_t side = cross(start, way);
  if (side != 0) return side < 0 ? 0 : 2;
  return start.x * way.x + start.y * way.y < 0 ? 1 : 3;
}

/// Whether a clockwise turn from `start` comes to a before b.
bool comes_first(const GridPoint& start, const GridPoint& a, const GridPoint& b) {
  const int part_a = part_of_turn(start, a), part_b = part_of_turn(start, b);
  return part_a != part_b ? part_a < part_b : cross(a, b) < 0;
}

void separate_place(Borders& borders, std::span<const std::uint32_t> corners) {
  const GridPoint here = borders.at(corners.front());
  const auto way_to = [&](const GridPoint& p) { return GridPoint{p.x - here.x, p.y - here.y}; };
  std::vector<std::uint32_t> exits;
  for (const std::uint32_t corner : corners) exits.push_back(borders.corners[corner].after);
  for (const std::uint32_t corner : corners) {
    const GridPoint arrival = way_to(borders.before(corner));
    const auto exit = std::min_element(exits.begin(), exits.end(), [&](std::uint32_t a, std::uint32_t b) {
      return comes_first(arrival, way_to(borders.at(a)), way_to(borders.at(b)));
    });
    borders.link(corner, *exit);
    exits.erase(exit);
  }
}

/// Twice the area; the sum may round, but hardly to another sign than its own.
double area_of(const Borders& borders, const std::vector<std::uint32_t>& ring) {
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    area += static_cast<double>(turn(borders.at(ring[0]), borders.at(ring[i - 1]), borders.at(ring[i])));
  }
  return area;
}

void find_borders(Borders& borders) {
  borders.outer.clear();
  borders.holes.clear();
  std::vector<char> seen(borders.corners.size());
  std::vector<std::uint32_t> ring;
  for (std::uint32_t first = 0; first < seen.size(); ++first) {
    if (seen[first] != 0) continue;
    ring.clear();
    for (std::uint32_t corner = first; seen[corner] == 0; corner = borders.corners[corner].after) {
      seen[corner] = 1;
      ring.push_back(corner);
    }
    const double area = area_of(borders, ring);
    if (area != 0) (area > 0 ? borders.outer : borders.holes).push_back(first);
  }
}

}  // namespace

void separate_touching(Borders& borders) {
  std::vector<std::uint32_t> order(borders.corners.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t corner) {
    return std::tuple(borders.at(corner).x, borders.at(corner).y, corner);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && borders.at(order[end]) == borders.at(order[i])) ++end;
    if (end - i > 1) separate_place(borders, std::span(order).subspan(i, end - i));
    i = end;
  }
  find_borders(borders);
}

}  // namespace straightedge
