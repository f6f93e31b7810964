// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "straightedge/inverse_depth.hpp"

namespace straightedge::detail {

/// Weighted sums for the least squares of q = c0 + c1 x + c2 y + c3 xx + c4 xy + c5 yy. Sums of two sets of
/// samples add up to those of both.
struct QuadraticSums {
  static constexpr std::size_t terms = 6, products = 15;
  /// Of 1, x, y, xx, xy, yy, xxx, xxy, xyy, yyy, xxxx, xxxy, xxyy, xyyy, yyyy: all products of two terms.
  std::array<double, products> moments{};
  std::array<double, terms> right{};
  double qq = 0;
  double n = 0;

  void add(double x, double y, double q, double weight) noexcept;
  void add(const QuadraticSums& other) noexcept;
  /// What was added before.
  void take_off(const QuadraticSums& other) noexcept;
};

/// A triangle of a symmetric matrix of the terms, row by row.
using QuadraticTriangle = std::array<double, QuadraticSums::terms*(QuadraticSums::terms + 1) / 2>;

struct QuadraticFit {
  std::array<double, QuadraticSums::terms> coefficients{};
  double squares = 0;       ///< sum of the weighted squared residuals, the ridge's penalty included
  double bend_squares = 0;  ///< what the last three terms explain beyond the first three
  QuadraticTriangle root;   ///< Cholesky's of the normal matrix, with the reciprocals of its diagonal
};

/// Least squares by Cholesky's decomposition. `ridge` is added to the diagonal of the last three terms: a
/// surface bends only as far as its samples insist. False when they do not settle it.
bool fit_quadratic(const QuadraticSums& sums, double ridge, QuadraticFit& fit) noexcept;

/// A lower bound for how many squared residuals more it costs that other samples lie on the surface of a fit,
/// too, than that they have one of their own (no ridge looked at): what their mean residual from it costs.
double least_cost(const QuadraticFit& fit, const QuadraticSums& others) noexcept;

/// A plane in inverse depth as a real sensor pictures it, slightly bent.
struct BentPlane {
  InverseDepthPlane plane;
  double uu = 0, uv = 0, vv = 0;  ///< about (u0, v0), 1/(metre pixel²)
  double u0 = 0, v0 = 0;

  constexpr double at(double u, double v) const noexcept {
    const double x = u - u0, y = v - v0;
    return plane.at(u, v) + uu * x * x + uv * x * y + vv * y * y;
  }
  /// The plane that touches it at a pixel.
  constexpr InverseDepthPlane tangent(double u, double v) const noexcept {
    const double x = u - u0, y = v - v0;
    const double a = plane.a + 2 * uu * x + uv * y;
    const double b = plane.b + uv * x + 2 * vv * y;
    return {a, b, at(u, v) - a * u - b * v};
  }
};

}  // namespace straightedge::detail
