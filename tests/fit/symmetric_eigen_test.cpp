// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/symmetric_eigen.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

using Upper = std::array<double, 6>;

Eigen::Matrix3d matrix_of(const Upper& a) {
  Eigen::Matrix3d m;
  m << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
  return m;
}

Eigen::Matrix3d vectors_of(const SymmetricEigen& eigen) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    const Vector3& v = eigen.vectors[static_cast<std::size_t>(i)];
    m.col(i) << v.x, v.y, v.z;
  }
  return m;
}

Upper random_upper(Pcg32& random) {
  Upper a{};
  for (double& entry : a) entry = support::uniform(random, -1, 1);
  return a;
}

Upper with_eigenvalues(Pcg32& random, double first, double second, double third) {
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(support::uniform(random, -3, 3),
                        Eigen::Vector3d(support::normal(random), support::normal(random), 1).normalized())
          .toRotationMatrix();
  const Eigen::Matrix3d m = r * Eigen::Vector3d(first, second, third).asDiagonal() * r.transpose();
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

/// What holds for every finite matrix: values as Eigen's, ascending, vectors orthonormal, A V = V D, signs.
void check_decomposition(const Upper& upper, double scale) {
  const SymmetricEigen eigen = symmetric_eigen(upper);
  const Eigen::Matrix3d a = matrix_of(upper) / scale;
  const Eigen::Vector3d expected = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a).eigenvalues();
  const Eigen::Matrix3d v = vectors_of(eigen);
  const Eigen::Vector3d values = Eigen::Vector3d(eigen.values[0], eigen.values[1], eigen.values[2]) / scale;
  CHECK((values - expected).cwiseAbs().maxCoeff() < 4e-15);
  CHECK((v.transpose() * v - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 4e-15);
  CHECK((a * v - v * values.asDiagonal()).cwiseAbs().maxCoeff() < 4e-15);
  CHECK(eigen.values[0] <= eigen.values[1]);
  CHECK(eigen.values[1] <= eigen.values[2]);
  for (int i = 0; i < 3; ++i) {
    Eigen::Index largest = 0;
    v.col(i).cwiseAbs().maxCoeff(&largest);
    CHECK(v(largest, i) > 0);
  }
}

}  // namespace

TEST_CASE("eigenvalues and eigenvectors of random matrices are those of Eigen") {
  constexpr std::uint64_t seed = 31;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    check_decomposition(random_upper(random), 1);
  }
}

TEST_CASE("equal, nearly equal and vanishing eigenvalues do no harm") {
  constexpr std::uint64_t seed = 32;
  CAPTURE(seed);
  Pcg32 random(seed);
  const double nearly = 1 + 1e-15;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    check_decomposition(with_eigenvalues(random, 1, 1, 1), 1);
    check_decomposition(with_eigenvalues(random, 0.5, 1, 1), 1);
    check_decomposition(with_eigenvalues(random, 0.5, 0.5, 1), 1);
    check_decomposition(with_eigenvalues(random, 0.5, 1, nearly), 1);
    check_decomposition(with_eigenvalues(random, 0, 0, 1), 1);
    check_decomposition(with_eigenvalues(random, -1, 0, 1), 1);
    check_decomposition(with_eigenvalues(random, 1e-14, 0.3, 1), 1);
  }
}

TEST_CASE("tiny and huge matrices are as exact as others") {
  constexpr std::uint64_t seed = 33;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (const double scale : {1e-300, 1e-200, 1e-30, 1e30, 1e200, 1e300}) {
    CAPTURE(scale);
    for (int i = 0; i < 100; ++i) {
      Upper a = random_upper(random);
      for (double& entry : a) entry *= scale;
      check_decomposition(a, scale);
    }
  }
}

TEST_CASE("matrices with extreme entries side by side give finite orthonormal vectors") {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max() / 4;
  for (const Upper& a : {Upper{least, least, least, least, least, least},
                         Upper{most, most, most, most, most, most}, Upper{1, 1e-300, 0, 1, 0, 1},
                         Upper{1, least, least, 2, least, 3}, Upper{most, least, 0, -most, 1, 0}}) {
    const SymmetricEigen eigen = symmetric_eigen(a);
    const Eigen::Matrix3d v = vectors_of(eigen);
    CHECK((v.transpose() * v - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 4e-15);
    for (const double value : eigen.values) CHECK(std::isfinite(value));
  }
}

TEST_CASE("the zero matrix and multiples of one have the axes as eigenvectors") {
  for (const double d : {0.0, 3.0, -2.0}) {
    const SymmetricEigen eigen = symmetric_eigen({d, 0, 0, d, 0, d});
    CHECK(eigen.values == std::array<double, 3>{d, d, d});
    CHECK(eigen.vectors == std::array<Vector3, 3>{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}});
  }
}

TEST_CASE("a diagonal matrix is sorted and otherwise left alone") {
  const SymmetricEigen eigen = symmetric_eigen({5, 0, 0, -7, 0, 2});
  CHECK(eigen.values == std::array<double, 3>{-7, 2, 5});
  CHECK(eigen.vectors == std::array<Vector3, 3>{Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{1, 0, 0}});
}

TEST_CASE("entries that are no finite numbers give NaN and the axes") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (std::size_t i = 0; i < 6; ++i) {
      Upper a{3, 1, 1, 4, 1, 5};
      a[i] = bad;
      const SymmetricEigen eigen = symmetric_eigen(a);
      for (const double value : eigen.values) CHECK(std::isnan(value));
      CHECK(eigen.vectors[2] == Vector3{0, 0, 1});
    }
  }
}
