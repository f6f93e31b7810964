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
    return faces_light(field.x.at(x, y), field.y.at(x, y));
  }
  bool faces_light(double gx, double gy) const noexcept {
    const double toward = gx * nx + gy * ny;
    return toward > 0 && toward * toward >= cos_max_angle * cos_max_angle * (gx * gx + gy * gy);
  }
};

/// Visits the pixels of a mask within a corridor's width, step by step along its major axis: a column a step,
/// or a row where the line is steep.
class CorridorSteps {
 public:
  CorridorSteps(GrayView mask, const Corridor& strip) noexcept
      : mask_(mask),
        steep_(strip.steep()),
        steps_(steep_ ? mask.height : mask.width),
        last_((steep_ ? mask.width : mask.height) - 1),
        slope_(steep_ ? strip.ny / strip.nx : strip.nx / strip.ny),
        from_(steep_ ? strip.py : strip.px),
        at_(steep_ ? strip.px : strip.py),
        reach_(strip.half_width / size_of(steep_ ? strip.nx : strip.ny)) {}

  /// Calls visit(x, y) for the pixels of step k. False when the step is outside the image.
  template <class Visit>
  bool visit(std::int32_t k, const Visit& visit) const noexcept {
    if (k < 0 || k >= steps_) return false;
    const double centre = at_ - (k - from_) * slope_;
    if (centre + reach_ < 0 || centre - reach_ > last_) return false;
    auto lo = static_cast<std::int32_t>(centre - reach_);
    auto hi = static_cast<std::int32_t>(centre + reach_) + 1;
    if (lo < 0) lo = 0;
    if (hi > last_) hi = last_;
    const std::ptrdiff_t stride = steep_ ? 1 : mask_.stride;
    const std::uint8_t* pixel = steep_ ? mask_.row(k) + lo : mask_.row(lo) + k;
    for (std::int32_t m = lo; m <= hi; ++m, pixel += stride)
      if (*pixel != 0) visit(steep_ ? m : k, steep_ ? k : m);
    return true;
  }

 private:
  static double size_of(double x) noexcept { return x < 0 ? -x : x; }

  GrayView mask_;
  bool steep_;
  std::int32_t steps_;
  std::int32_t last_;
  double slope_, from_, at_, reach_;
};

}  // namespace straightedge
