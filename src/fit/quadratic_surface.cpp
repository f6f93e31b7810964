// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/detail/quadratic_surface.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

constexpr std::size_t terms = QuadraticSums::terms;

constexpr std::size_t place(std::size_t row, std::size_t column) noexcept {
  return row * (row + 1) / 2 + column;
}

// Which of the moments each product of two terms is: the lower triangle, row by row.
constexpr std::array<std::size_t, terms*(terms + 1) / 2> moment_of{0, 1, 3,  2,  4, 5, 3, 6,  7,  10, 4,
                                                                   7, 8, 11, 12, 5, 8, 9, 12, 13, 14};

/// Lower triangle of the decomposition, in place; of the diagonal the reciprocals. False for a matrix that is
/// not positive definite.
bool decompose(QuadraticTriangle& m) noexcept {
  for (std::size_t i = 0; i < terms; ++i) {
    const double before = m[place(i, i)];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[place(i, j)];
      for (std::size_t k = 0; k < j; ++k) sum -= m[place(i, k)] * m[place(j, k)];
      if (i != j) {
        m[place(i, j)] = sum * m[place(j, j)];
      } else {
        if (!(sum > 1e-12 * before)) return false;  // what is left is rounding
        m[place(i, i)] = 1 / square_root(sum);
      }
    }
  }
  return true;
}

}  // namespace

void QuadraticSums::add(double x, double y, double q, double weight) noexcept {
  const double xx = x * x, xy = x * y, yy = y * y;
  const double wx = weight * x, wy = weight * y, wxx = weight * xx, wxy = weight * xy, wyy = weight * yy;
  const double wq = weight * q;
  const std::array<double, products> of{weight,   wx,       wy,       wxx,      wxy,
                                        wyy,      wxx * x,  wxx * y,  wyy * x,  wyy * y,
                                        wxx * xx, wxx * xy, wxx * yy, wyy * xy, wyy * yy};
  const std::array<double, terms> with_q{wq, wq * x, wq * y, wq * xx, wq * xy, wq * yy};
  for (std::size_t i = 0; i < products; ++i) moments[i] += of[i];
  for (std::size_t i = 0; i < terms; ++i) right[i] += with_q[i];
  qq += wq * q;
  n += weight;
}

void QuadraticSums::add(const QuadraticSums& other) noexcept {
  for (std::size_t i = 0; i < products; ++i) moments[i] += other.moments[i];
  for (std::size_t i = 0; i < terms; ++i) right[i] += other.right[i];
  qq += other.qq;
  n += other.n;
}

void QuadraticSums::take_off(const QuadraticSums& other) noexcept {
  for (std::size_t i = 0; i < products; ++i) moments[i] -= other.moments[i];
  for (std::size_t i = 0; i < terms; ++i) right[i] -= other.right[i];
  qq -= other.qq;
  n -= other.n;
}

bool fit_quadratic(const QuadraticSums& sums, double ridge, QuadraticFit& fit) noexcept {
  QuadraticTriangle& lower = fit.root;
  for (std::size_t i = 0; i < lower.size(); ++i) lower[i] = sums.moments[moment_of[i]];
  for (std::size_t i = 3; i < terms; ++i) lower[place(i, i)] += ridge;
  if (!(sums.n > 0) || !decompose(lower)) return false;
  std::array<double, terms> solved{};
  double explained = 0;
  fit.bend_squares = 0;
  for (std::size_t i = 0; i < terms; ++i) {
    double sum = sums.right[i];
    for (std::size_t k = 0; k < i; ++k) sum -= lower[place(i, k)] * solved[k];
    solved[i] = sum * lower[place(i, i)];
    explained += solved[i] * solved[i];
    if (i >= 3) fit.bend_squares += solved[i] * solved[i];
  }
  for (std::size_t i = terms; i-- > 0;) {
    double sum = solved[i];
    for (std::size_t k = i + 1; k < terms; ++k) sum -= lower[place(k, i)] * fit.coefficients[k];
    fit.coefficients[i] = sum * lower[place(i, i)];
  }
  fit.squares = sums.qq > explained ? sums.qq - explained : 0;
  return true;
}

double least_cost(const QuadraticFit& fit, const QuadraticSums& others) noexcept {
  // The residual of their mean, of variance 1/n, from a prediction: the mean of the terms, propagated.
  const double inverse_n = 1 / others.n;
  double off = others.right[0], variance = 0;
  std::array<double, terms> solved;
  for (std::size_t i = 0; i < terms; ++i) {
    const double mean = others.moments[i] * inverse_n;
    double sum = mean;
    for (std::size_t k = 0; k < i; ++k) sum -= fit.root[place(i, k)] * solved[k];
    solved[i] = sum * fit.root[place(i, i)];
    variance += solved[i] * solved[i];
    off -= fit.coefficients[i] * others.moments[i];
  }
  off *= inverse_n;
  return off * off / (variance + inverse_n);
}

}  // namespace straightedge::detail
