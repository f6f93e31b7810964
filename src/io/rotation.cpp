// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/rotation.hpp"

#include <cmath>
#include <cstddef>

namespace straightedge::io {
namespace {

using Matrix = std::array<double, 9>;

/// The cofactors: determinant times inverse, transposed.
Matrix cofactors(const Matrix& m) {
  return {m[4] * m[8] - m[5] * m[7], m[5] * m[6] - m[3] * m[8], m[3] * m[7] - m[4] * m[6],
          m[2] * m[7] - m[1] * m[8], m[0] * m[8] - m[2] * m[6], m[1] * m[6] - m[0] * m[7],
          m[1] * m[5] - m[2] * m[4], m[2] * m[3] - m[0] * m[5], m[0] * m[4] - m[1] * m[3]};
}

double determinant(const Matrix& m, const Matrix& c) {
  return m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
}

/// The columns are unit vectors at right angles, up to the tolerance. NaN is not.
bool nearly_orthonormal(const Matrix& m) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double product = m[i] * m[j] + m[i + 3] * m[j + 3] + m[i + 6] * m[j + 6];
      if (!(std::abs(product - (i == j ? 1 : 0)) <= rotation_tolerance)) return false;
    }
  }
  return true;
}

}  // namespace

const char* take_rotation(const Matrix& matrix, Pose& pose) noexcept {
  if (!nearly_orthonormal(matrix)) return "the matrix is no rotation";
  Matrix m = matrix;
  if (determinant(m, cofactors(m)) < 0) return "the matrix mirrors";
  for (int step = 0; step < 5; ++step) {
    const Matrix c = cofactors(m);
    const double d = determinant(m, c);
    for (std::size_t i = 0; i < 9; ++i) m[i] = (m[i] + c[i] / d) / 2;
  }
  pose.rotation = m;
  return nullptr;
}

const char* take_rotation(const std::array<double, 4>& quaternion, Pose& pose) noexcept {
  auto [x, y, z, w] = quaternion;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (length == 0) return "the quaternion is zero";
  if (!(std::abs(length - 1) <= rotation_tolerance)) return "the quaternion's length is not 1";
  x /= length, y /= length, z /= length, w /= length;
  pose.rotation = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
                   2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                   2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
  return nullptr;
}

}  // namespace straightedge::io
