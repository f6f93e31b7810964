// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "straightedge/vector3.hpp"

namespace straightedge::detail {

/// Upper triangle, row by row, of a symmetric 3x3 matrix.
using Upper3 = std::array<double, 6>;

/// Rows of a 3x3 matrix.
struct Rows3 {
  Vector3 first, second, third;
};

inline Vector3 product(const Upper3& c, const Vector3& x) noexcept {
  return {c[0] * x.x + c[1] * x.y + c[2] * x.z, c[1] * x.x + c[3] * x.y + c[4] * x.z,
          c[2] * x.x + c[4] * x.y + c[5] * x.z};
}

inline Upper3 sum(const Upper3& a, const Upper3& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5]};
}

/// J C Jᵀ: the covariance of J x where C is that of x.
inline Upper3 propagated(const Rows3& j, const Upper3& c) noexcept {
  const Vector3 first = product(c, j.first);
  const Vector3 second = product(c, j.second);
  const Vector3 third = product(c, j.third);
  return {dot(first, j.first),   dot(first, j.second), dot(first, j.third),
          dot(second, j.second), dot(second, j.third), dot(third, j.third)};
}

/// L D Lᵀ of a positive definite matrix.
struct Factored3 {
  double l10 = 0, l20 = 0, l21 = 0;
  double d0 = 0, d1 = 0, d2 = 0;

  Vector3 solve(const Vector3& right) const noexcept {
    const double y0 = right.x;
    const double y1 = right.y - l10 * y0;
    const double y2 = right.z - l20 * y0 - l21 * y1;
    const double x2 = y2 / d2;
    const double x1 = y1 / d1 - l21 * x2;
    return {y0 / d0 - l10 * x1 - l20 * x2, x1, x2};
  }
  Upper3 inverse() const noexcept {
    const Vector3 first = solve({1, 0, 0});
    const Vector3 second = solve({0, 1, 0});
    const Vector3 third = solve({0, 0, 1});
    return {first.x, first.y, first.z, second.y, second.z, third.z};
  }
};

/// False for a matrix that is not positive definite, or so little that rounding might have made it so.
inline bool factor(const Upper3& c, Factored3& f) noexcept {
  constexpr double rounding = 1e-14;
  f.d0 = c[0];
  if (!(f.d0 > 0)) return false;
  f.l10 = c[1] / f.d0;
  f.l20 = c[2] / f.d0;
  f.d1 = c[3] - f.l10 * c[1];
  if (!(f.d1 > rounding * c[3])) return false;
  const double below = c[4] - f.l20 * c[1];
  f.l21 = below / f.d1;
  f.d2 = c[5] - f.l20 * c[2] - f.l21 * below;
  return f.d2 > rounding * c[5] && f.d0 - f.d0 == 0 && f.d1 - f.d1 == 0 && f.d2 - f.d2 == 0;
}

}  // namespace straightedge::detail
