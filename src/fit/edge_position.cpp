// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/edge_position.hpp"

namespace straightedge {
namespace {

// A pixel's position is never better than this, however sharp the edge: staircases of slanted walls.
constexpr double position_floor = 0.25;
// Share of the magnitude by which neighbours differ through noise alone.
constexpr double relative_noise = 0.08;

std::int32_t size_of(std::int32_t value) noexcept {
  return value < 0 ? -value : value;
}

}  // namespace

EdgePosition edge_position(const GradientField& field, std::int32_t x, std::int32_t y) noexcept {
  EdgePosition edge{static_cast<double>(x), static_cast<double>(y), 1.0};
  // Step 1.
  const bool across_columns = size_of(field.x.at(x, y)) >= size_of(field.y.at(x, y));
  const std::int32_t step_x = across_columns ? 1 : 0;
  const std::int32_t step_y = across_columns ? 0 : 1;
  if (!field.magnitude.contains(x - 2 * step_x, y - 2 * step_y) ||
      !field.magnitude.contains(x + 2 * step_x, y + 2 * step_y)) {
    return edge;
  }
  const auto at = [&](std::int32_t k) noexcept { return field.magnitude.at(x + k * step_x, y + k * step_y); };
  // Step 2.
  const std::int32_t top = at(-1) > at(0) && at(-1) >= at(1) ? -1 : at(1) > at(0) ? 1 : 0;
  // Step 3.
  const double before = at(top - 1);
  const double here = at(top);
  const double after = at(top + 1);
  const double curvature = 2 * here - before - after;
  if (!(curvature > 0)) return edge;
  double shift = 0.5 * (after - before) / curvature;
  shift = top + (shift < -0.5 ? -0.5 : shift > 0.5 ? 0.5 : shift);
  edge.x += shift * step_x;
  edge.y += shift * step_y;
  // Step 4.
  const double noise = relative_noise * here / curvature;
  edge.variance = position_floor * position_floor + noise * noise;
  return edge;
}

}  // namespace straightedge
