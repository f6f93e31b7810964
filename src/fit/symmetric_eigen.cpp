// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/symmetric_eigen.hpp"

#include <bit>
#include <cstdint>

#include "straightedge/square_root.hpp"

namespace straightedge {
namespace {

constexpr int sweeps = 8;
// Far below the rounding of entries of size 1.
constexpr double negligible = 1e-20;

double size_of(double value) noexcept {
  return value < 0 ? -value : value;
}

/// The power of two at or below a positive number, but not below the least normal one, whose inverse is
/// finite.
double power_of_two_below(double value) noexcept {
  constexpr std::uint64_t exponent_bits = 0x7ff0000000000000U;
  constexpr double least_normal = 2.2250738585072014e-308;
  const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & exponent_bits);
  return power > least_normal ? power : least_normal;
}

/// The matrix on its way to a diagonal, and the axes, turned by every rotation.
struct Jacobi {
  double a[3][3];
  Vector3 vectors[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  /// Makes entry (p, q) zero.
  void rotate(int p, int q) noexcept {
    const double pq = a[p][q];
    if (size_of(pq) < negligible) {
      a[p][q] = 0;
      return;
    }
    const double cotangent = (a[q][q] - a[p][p]) / (2 * pq);  // of twice the angle
    const double root = square_root(cotangent * cotangent + 1);
    const double t = cotangent < 0 ? 1 / (cotangent - root) : 1 / (cotangent + root);
    const double c = 1 / square_root(t * t + 1);
    const double s = t * c;
    a[p][p] -= t * pq;
    a[q][q] += t * pq;
    a[p][q] = 0;
    const int r = 3 - p - q;
    double& pr = p < r ? a[p][r] : a[r][p];
    double& qr = q < r ? a[q][r] : a[r][q];
    const double old_pr = pr;
    pr = c * old_pr - s * qr;
    qr = s * old_pr + c * qr;
    // Axis by axis, not coordinate by coordinate: GCC 12 would fuse such pairs of a sum and a difference of
    // products where the machine can, and change the last bits.
    const Vector3 old_p = vectors[p];
    vectors[p] = c * old_p - s * vectors[q];
    vectors[q] = s * old_p + c * vectors[q];
  }
};

Vector3 with_fixed_sign(const Vector3& v) noexcept {
  double largest = v.x;
  if (size_of(v.y) > size_of(largest)) largest = v.y;
  if (size_of(v.z) > size_of(largest)) largest = v.z;
  return largest < 0 ? -v : v;
}

void order(int& first, int& second, const double (&values)[3]) noexcept {
  if (values[second] < values[first] || (values[second] == values[first] && second < first)) {
    const int other = first;
    first = second;
    second = other;
  }
}

}  // namespace

SymmetricEigen symmetric_eigen(const std::array<double, 6>& upper) noexcept {
  SymmetricEigen eigen;
  // Step 1.
  double largest = 0;
  double finite = 0;
  for (const double entry : upper) {
    if (size_of(entry) > largest) largest = size_of(entry);
    finite += entry - entry;
  }
  if (finite != 0) {
    eigen.values = {finite, finite, finite};
    return eigen;
  }
  const double scale = power_of_two_below(largest);
  const double shrink = 1 / scale;
  Jacobi jacobi{{{upper[0] * shrink, upper[1] * shrink, upper[2] * shrink},
                 {0, upper[3] * shrink, upper[4] * shrink},
                 {0, 0, upper[5] * shrink}}};
  // Step 2.
  for (int i = 0; i < sweeps; ++i) {
    jacobi.rotate(0, 1);
    jacobi.rotate(0, 2);
    jacobi.rotate(1, 2);
    if (jacobi.a[0][1] == 0 && jacobi.a[0][2] == 0) break;
  }
  // Step 3.
  const double values[3] = {jacobi.a[0][0], jacobi.a[1][1], jacobi.a[2][2]};
  std::array<int, 3> column{0, 1, 2};
  order(column[0], column[1], values);
  order(column[1], column[2], values);
  order(column[0], column[1], values);
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = column[i];
    eigen.values[i] = values[k] * scale;
    eigen.vectors[i] = with_fixed_sign(jacobi.vectors[k]);
  }
  return eigen;
}

}  // namespace straightedge
