// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"

namespace straightedge::refitting {

/// Right minus left, below minus above.
struct EdgeGradient {
  double dx = 0, dy = 0;
};

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
  /// Along the line, from one step of the major axis to the next.
  double step_length() const noexcept { return 1 / (steep() ? (nx < 0 ? -nx : nx) : (ny < 0 ? -ny : ny)); }
  double along(double x, double y) const noexcept { return (x - px) * tx() + (y - py) * ty(); }
  double across(double x, double y) const noexcept { return (x - px) * nx + (y - py) * ny; }

  /// Whether a gradient points to the light side.
  bool faces_light(const EdgeGradient& gradient) const noexcept {
    const double gx = gradient.dx, gy = gradient.dy;
    const double toward = gx * nx + gy * ny;
    return toward > 0 && toward * toward >= cos_max_angle * cos_max_angle * (gx * gx + gy * gy);
  }
};

/// Visits the edge pixels within a corridor's width, step by step along its major axis: a column a step, or a
/// row where the line is steep.
template <class Edges>
class CorridorSteps {
 public:
  CorridorSteps(const Edges& edges, const Corridor& strip) noexcept
      : edges_(edges),
        steep_(strip.steep()),
        steps_(steep_ ? edges.size().height : edges.size().width),
        last_((steep_ ? edges.size().width : edges.size().height) - 1),
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
    edges_.for_each(steep_, k, lo, hi, visit);
    return true;
  }

  /// No step has more pixels.
  std::int32_t most_in_step() const noexcept { return static_cast<std::int32_t>(2 * reach_) + 3; }

 private:
  static double size_of(double x) noexcept { return x < 0 ? -x : x; }

  const Edges& edges_;
  bool steep_;
  std::int32_t steps_;
  std::int32_t last_;
  double slope_, from_, at_, reach_;
};

}  // namespace straightedge::refitting
