// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/detail/arc_tangents_of_eighths.hpp"

/// Sine, cosine and arc tangent from + − × ÷ alone, so that every machine and compiler gives the
/// same bits; the C library's may differ in the last one. Absolute error below 4e-16 for |x| <= 100.
///
/// Steps: (1) bring the argument near zero by subtracting a multiple of pi/2 (kept in three parts) or
/// the nearest eighth; (2) sum the Taylor series, smallest term first; (3) put quadrant or eighth back.
namespace straightedge {

inline constexpr double pi = 3.141592653589793;
inline constexpr double degree = pi / 180;

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

namespace detail {

/// sin x for |x| <= pi/4.
constexpr double sine_near_zero(double x) noexcept {
  const double s = x * x;
  double sum = 1.0 / 355687428096000.0;
  sum = sum * s - 1.0 / 1307674368000.0;
  sum = sum * s + 1.0 / 6227020800.0;
  sum = sum * s - 1.0 / 39916800.0;
  sum = sum * s + 1.0 / 362880.0;
  sum = sum * s - 1.0 / 5040.0;
  sum = sum * s + 1.0 / 120.0;
  sum = sum * s - 1.0 / 6.0;
  return x + x * s * sum;
}

/// cos x for |x| <= pi/4.
constexpr double cosine_near_zero(double x) noexcept {
  const double s = x * x;
  double sum = 1.0 / 87178291200.0 - s / 20922789888000.0;
  sum = 1.0 / 479001600.0 - sum * s;
  sum = 1.0 / 3628800.0 - sum * s;
  sum = 1.0 / 40320.0 - sum * s;
  sum = 1.0 / 720.0 - sum * s;
  sum = 1.0 / 24.0 - sum * s;
  return (1.0 - 0.5 * s) + s * s * sum;
}

}  // namespace detail

/// Both at once. NaN and infinity give NaN.
constexpr SineCosine sine_cosine(double x) noexcept {
  // Step 1. pi/2 in three parts, the first two with 33 bits: products with small n are exact.
  constexpr double half_pi_1 = 1.5707963267341256;
  constexpr double half_pi_2 = 6.077100506303966e-11;
  constexpr double half_pi_3 = 2.0222662487959506e-21;
  if (!(x > -1e8 && x < 1e8)) return {x - x == 0 ? 0.0 : x - x, x - x == 0 ? 1.0 : x - x};
  const double turns = x * (2 / pi);
  const auto n = static_cast<long long>(turns + (turns < 0 ? -0.5 : 0.5));
  const auto m = static_cast<double>(n);
  const double r = ((x - m * half_pi_1) - m * half_pi_2) - m * half_pi_3;
  // Step 2.
  const double s = detail::sine_near_zero(r);
  const double c = detail::cosine_near_zero(r);
  // Step 3.
  switch (n & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

constexpr double sine(double x) noexcept {
  return sine_cosine(x).sine;
}
constexpr double cosine(double x) noexcept {
  return sine_cosine(x).cosine;
}

/// The angle of the vector (x, y), in (−pi, pi]; 0 for the null vector. NaN gives NaN, and so do two
/// infinities.
constexpr double arc_tangent(double y, double x) noexcept {
  const double ax = x < 0 ? -x : x;
  const double ay = y < 0 ? -y : y;
  if (ax == 0 && ay == 0) return 0;
  // Step 1.
  const bool steep = ay > ax;
  const double t = steep ? ax / ay : ay / ax;
  if (!(t >= 0 && t <= 1)) return x - x + (y - y);  // NaN, or both infinite
  const int k = static_cast<int>(t * 8 + 0.5);
  const double c = k / 8.0;
  const double u = (t - c) / (1 + t * c);
  // Step 2.
  const double s = u * u;
  double sum = 1.0 / 13.0;
  sum = 1.0 / 11.0 - s * sum;
  sum = 1.0 / 9.0 - s * sum;
  sum = 1.0 / 7.0 - s * sum;
  sum = 1.0 / 5.0 - s * sum;
  sum = 1.0 / 3.0 - s * sum;
  double angle = detail::arc_tangents_of_eighths[k] + (u - u * s * sum);
  // Step 3.
  if (steep) angle = pi / 2 - angle;
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

/// The same direction in (−pi, pi]; for sums of a few angles, |angle| < 1e6.
constexpr double wrap_angle(double angle) noexcept {
  if (!(angle > -1e6 && angle < 1e6)) return 0;
  while (angle > pi) angle -= 2 * pi;
  while (angle <= -pi) angle += 2 * pi;
  return angle;
}

}  // namespace straightedge
