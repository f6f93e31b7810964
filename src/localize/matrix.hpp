// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace straightedge::localize {

/// A small matrix, row by row. All sums run in index order, so that the bits are the same everywhere.
template <std::size_t rows, std::size_t columns>
struct Matrix {
  std::array<double, rows * columns> v{};

  constexpr double& operator()(std::size_t r, std::size_t c) noexcept { return v[r * columns + c]; }
  constexpr double operator()(std::size_t r, std::size_t c) const noexcept { return v[r * columns + c]; }

  constexpr Matrix& operator+=(const Matrix& other) noexcept {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += other.v[i];
    return *this;
  }
  constexpr Matrix& operator-=(const Matrix& other) noexcept {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] -= other.v[i];
    return *this;
  }
};

using Matrix3 = Matrix<3, 3>;
using Matrix2 = Matrix<2, 2>;

template <std::size_t n, std::size_t k, std::size_t m>
constexpr Matrix<n, m> operator*(const Matrix<n, k>& a, const Matrix<k, m>& b) noexcept {
  Matrix<n, m> out;
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < m; ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < k; ++i) sum += a(r, i) * b(i, c);
      out(r, c) = sum;
    }
  }
  return out;
}

template <std::size_t n, std::size_t m>
constexpr Matrix<m, n> transposed(const Matrix<n, m>& a) noexcept {
  Matrix<m, n> out;
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < m; ++c) out(c, r) = a(r, c);
  }
  return out;
}

template <std::size_t n, std::size_t m>
constexpr Matrix<n, m> operator+(Matrix<n, m> a, const Matrix<n, m>& b) noexcept {
  return a += b;
}

/// Both triangles made equal.
template <std::size_t n>
constexpr void make_symmetric(Matrix<n, n>& a) noexcept {
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = r + 1; c < n; ++c) a(r, c) = a(c, r) = 0.5 * (a(r, c) + a(c, r));
  }
}

/// The inverse of a symmetric positive matrix; false when it is not positive.
constexpr bool invert(const Matrix2& a, Matrix2& inverse) noexcept {
  const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  if (!(determinant > 0) || !(a(0, 0) > 0)) return false;
  inverse(0, 0) = a(1, 1) / determinant;
  inverse(1, 1) = a(0, 0) / determinant;
  inverse(0, 1) = -a(0, 1) / determinant;
  inverse(1, 0) = -a(1, 0) / determinant;
  return true;
}

}  // namespace straightedge::localize
