// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge::cli {
namespace {

/// Cuts [from, to], the places t on p + t d, to where p + t d lies in [low, high].
void cut(double p, double d, double low, double high, double& from, double& to) {
  if (std::abs(d) < 1e-9) {
    if (p < low || p > high) to = from - 1;
    return;
  }
  const double a = (low - p) / d, b = (high - p) / d;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

}  // namespace

std::optional<Chord> chord_of(const HoughPeak& line, Size size) {
  const Point2 normal = line_normal(static_cast<double>(line.theta));
  const Point2 along{-normal.y, normal.x};
  const double rho = static_cast<double>(line.rho);
  const Point2 foot{rho * normal.x, rho * normal.y};
  double from = -1e9, to = 1e9;
  cut(foot.x, along.x, -0.5, size.width - 0.5, from, to);
  cut(foot.y, along.y, -0.5, size.height - 0.5, from, to);
  if (!(from <= to)) return {};
  return Chord{{foot.x + from * along.x, foot.y + from * along.y},
               {foot.x + to * along.x, foot.y + to * along.y}};
}

double distance_to(const HoughPeak& line, Point2 point) {
  return std::abs(dot(line_normal(static_cast<double>(line.theta)), point) - static_cast<double>(line.rho));
}

}  // namespace straightedge::cli
