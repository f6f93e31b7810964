// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/edge_position.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// A strip of pixels along a directed line: through (px, py), light side towards the unit normal (nx, ny),
/// travelling along (−ny, nx).
struct Corridor {
  double px = 0, py = 0;
  double nx = 1, ny = 0;
  double half_width = 1.5;
  double cos_max_angle = 0.9;

  double tx() const noexcept { return -ny; }
  double ty() const noexcept { return nx; }
  bool steep() const noexcept { return nx * nx > ny * ny; }  // runs along rows' change, not columns'
  double along(double x, double y) const noexcept { return (x - px) * tx() + (y - py) * ty(); }
  double across(double x, double y) const noexcept { return (x - px) * nx + (y - py) * ny; }

  /// Whether the gradient at the pixel points to the light side.
  bool faces_light(const GradientField& field, std::int32_t x, std::int32_t y) const noexcept {
    const double gx = field.x.at(x, y);
    const double gy = field.y.at(x, y);
    const double toward = gx * nx + gy * ny;
    return toward > 0 && toward * toward >= cos_max_angle * cos_max_angle * (gx * gx + gy * gy);
  }
};

/// Calls visit(x, y) for every pixel of the mask within the corridor's width at step `k` of its major
/// axis (column k, or row k where the line is steep). False when the step is outside the image.
template <class Visit>
bool visit_step(GrayView mask, const Corridor& strip, std::int32_t k, const Visit& visit) noexcept {
  const bool steep = strip.steep();
  const std::int32_t steps = steep ? mask.height : mask.width;
  if (k < 0 || k >= steps) return false;
  const double major = steep ? strip.ny : strip.nx;
  const double minor = steep ? strip.nx : strip.ny;
  const double from = steep ? strip.py : strip.px;
  const double at = steep ? strip.px : strip.py;
  const double centre = at - (k - from) * major / minor;
  const double reach = strip.half_width / (minor < 0 ? -minor : minor);
  const std::int32_t last = (steep ? mask.width : mask.height) - 1;
  if (centre + reach < 0 || centre - reach > last) return false;
  auto lo = static_cast<std::int32_t>(centre - reach);
  auto hi = static_cast<std::int32_t>(centre + reach) + 1;
  if (lo < 0) lo = 0;
  if (hi > last) hi = last;
  for (std::int32_t m = lo; m <= hi; ++m) {
    const std::int32_t x = steep ? m : k;
    const std::int32_t y = steep ? k : m;
    if (mask.at(x, y) != 0) visit(x, y);
  }
  return true;
}

}  // namespace straightedge
