// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/map_rules.hpp"

#include <array>

namespace straightedge::io {

// A matrix has no eigenvalue below −e exactly when adding e to its diagonal makes it positive definite, that
// is, when Cholesky's method then meets no pivot of zero or less.
bool is_semidefinite(std::span<const double> upper, std::span<const double> scales) {
  constexpr double rounding = 1e-9;
  constexpr std::size_t most = 4;
  const std::size_t size = scales.size();
  std::array<std::array<double, most>, most> matrix{};
  for (std::size_t row = 0, next = 0; row < size; ++row) {
    for (std::size_t column = row; column < size; ++column, ++next) {
      const bool certain = scales[row] == 0 || scales[column] == 0;
      if (certain && upper[next] != 0) return false;
      matrix[row][column] = certain ? 0 : upper[next] / scales[row] / scales[column];
    }
    matrix[row][row] += rounding;
  }
  for (std::size_t pivot = 0; pivot < size; ++pivot) {
    if (!(matrix[pivot][pivot] > 0)) return false;
    for (std::size_t row = pivot + 1; row < size; ++row) {
      const double factor = matrix[pivot][row] / matrix[pivot][pivot];
      for (std::size_t column = row; column < size; ++column) {
        matrix[row][column] -= factor * matrix[pivot][column];
      }
    }
  }
  return true;
}

}  // namespace straightedge::io
