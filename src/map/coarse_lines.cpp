// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/coarse_lines.hpp"

#include <algorithm>

namespace straightedge {
namespace {

// 1 / variance of an end that lies anywhere within a pixel to both sides.
constexpr double end_weight = 3;

/// Where the picture gets lighter at the segment's ends, along a normal.
double towards_light(const HoughSegment& s, GradientView gradients, double nx, double ny) {
  const double dx = gradients.dx.at(s.x0, s.y0) + gradients.dx.at(s.x1, s.y1);
  const double dy = gradients.dy.at(s.x0, s.y0) + gradients.dy.at(s.x1, s.y1);
  return dx * nx + dy * ny;
}

}  // namespace

std::vector<WallLine> coarse_lines(std::span<const HoughSegment> rough, GradientView gradients,
                                   double min_length) {
  std::vector<WallLine> lines;
  for (const HoughSegment& s : rough) {
    WallLine line;
    line.origin_x = s.x0;
    line.origin_y = s.y0;
    line.moments.add(0, 0, end_weight);
    line.moments.add(s.x1 - s.x0, s.y1 - s.y0, end_weight);
    if (fit_line(line.moments, line.fit) != Status::ok) continue;
    line.fit.centroid_x += s.x0;
    line.fit.centroid_y += s.y0;
    const double side = towards_light(s, gradients, line.fit.normal_x, line.fit.normal_y) < 0 ? -1 : 1;
    line.nx = side * line.fit.normal_x;
    line.ny = side * line.fit.normal_y;
    const double a = line.along(s.x0, s.y0), b = line.along(s.x1, s.y1);
    line.begin = std::min(a, b);
    line.end = std::max(a, b);
    line.pixels = static_cast<std::uint32_t>(std::max(s.pixels, 0));
    line.votes = static_cast<std::uint32_t>(std::max(s.votes, 0));
    if (line.length() >= min_length) lines.push_back(line);
  }
  return lines;
}

}  // namespace straightedge
