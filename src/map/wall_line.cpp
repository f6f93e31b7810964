// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/wall_line.hpp"

#include <algorithm>

namespace straightedge {

Span WallLine::span_of(const WallLine& other) const {
  const double s0 = along(other.x_at(other.begin), other.y_at(other.begin));
  const double s1 = along(other.x_at(other.end), other.y_at(other.end));
  return {std::min(s0, s1), std::max(s0, s1)};
}

void WallLine::adopt(const LineMoments& sums, double about_x, double about_y) {
  LineFit better;
  if (fit_line(sums, better) != Status::ok) return;
  const double x0 = x_at(begin), y0 = y_at(begin);
  const double x1 = x_at(end), y1 = y_at(end);
  better.centroid_x += about_x;
  better.centroid_y += about_y;
  const double side = better.normal_x * nx + better.normal_y * ny < 0 ? -1 : 1;
  moments = sums;
  origin_x = about_x;
  origin_y = about_y;
  fit = better;
  nx = side * better.normal_x;
  ny = side * better.normal_y;
  begin = along(x0, y0);
  end = along(x1, y1);
}

void sort_longest_first(std::vector<WallLine>& lines) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const WallLine& a, const WallLine& b) { return a.length() > b.length(); });
}

WallLine wall_line_from(const RefinedSegment& segment, std::uint32_t votes) {
  WallLine line;
  line.moments = segment.moments;
  line.origin_x = segment.origin_x;
  line.origin_y = segment.origin_y;
  line.fit = segment.fit;
  line.nx = segment.light_x;
  line.ny = segment.light_y;
  line.begin = segment.begin;
  line.end = segment.end;
  line.pixels = segment.pixels;
  line.votes = votes;
  return line;
}

}  // namespace straightedge
