// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "straightedge/trigonometry.hpp"

namespace straightedge::io {

/// One sigma of a place in the plane.
struct Ellipse {
  double long_sigma = 0;
  double short_sigma = 0;
  double angle = 0;  ///< of the long axis
};

/// From the covariance of (x, y, heading), row by row; none when it is no covariance.
inline std::optional<Ellipse> ellipse_of(const std::array<double, 9>& covariance) {
  const double xx = covariance[0], xy = covariance[1], yy = covariance[4];
  const double middle = 0.5 * (xx + yy);
  const double spread = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  if (!(middle + spread > 0) || !(middle + spread < 1e12)) return {};
  return Ellipse{std::sqrt(middle + spread), std::sqrt(middle > spread ? middle - spread : 0),
                 0.5 * arc_tangent(2 * xy, xx - yy)};
}

}  // namespace straightedge::io
