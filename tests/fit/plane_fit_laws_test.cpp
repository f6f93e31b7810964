// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "noisy_patch.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using namespace noisy;

TEST_CASE("errors of the orthogonal fit are as large as its covariance says") {
  constexpr std::uint64_t seed = 61;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Gated gated = gate_of([&] {
    const Patch patch = random_patch(random);
    return support::nees(noisy_fit(patch, -0.4, 0.4, random), plane_of(patch));
  });
  CHECK(gated.mean > 2.5);
  CHECK(gated.mean < 3.5);
  CHECK(gated.mean == Approx(3).margin(mean_tolerance));
  CHECK(gated.rejected == Approx(0.01).margin(share_tolerance));
}

TEST_CASE("moving a fit is fitting moved points") {
  constexpr std::uint64_t seed = 69;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const Patch patch = random_patch(random);
    const Motion motion = random_motion(random);
    PlaneMoments here, there;
    for (int k = 0; k < 60; ++k) {
      const Vector3 p = patch.centre + support::normal(random) * patch.u + support::normal(random) * patch.v +
                        0.01 * support::normal(random) * patch.normal;
      here.add(p, 1e4);
      there.add(motion(p), 1e4);
    }
    const PlaneFit expected = fit_of(there);
    const PlaneFit fit = moved(fit_of(here), motion.rotation, motion.t);
    CHECK(length(fit.plane.normal - expected.plane.normal) < 1e-9);
    CHECK(fit.plane.distance == Approx(expected.plane.distance).margin(1e-9));
    CHECK(length(fit.centroid - expected.centroid) < 1e-9);
    CHECK(length(cross(fit.tangent_u, fit.tangent_v) - fit.plane.normal) < 1e-14);
    check_same_covariance(fit, expected, 1e-6);
  }
}

TEST_CASE("errors move as normals and distances do, also when the normal turns") {
  constexpr std::uint64_t seed = 70;
  CAPTURE(seed);
  Pcg32 random(seed);
  int turned = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    PlaneFit fit = noisy_fit(random_patch(random), -0.4, 0.4, random);
    const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return support::normal(random); });
    const Eigen::Matrix3d c = root * root.transpose();
    fit.covariance = {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
    const Motion motion = random_motion(random);
    const PlaneFit there = moved(fit, motion.rotation, motion.t);
    const Eigen::Matrix3d r =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(motion.rotation.data());
    turned += support::eigen(there.plane.normal).dot(r * support::eigen(fit.plane.normal)) < 0 ? 1 : 0;
    // n' = R n, d' = d + t·n'; the sign of (n', d') does not matter to the covariance.
    Eigen::Matrix4d jacobian = Eigen::Matrix4d::Identity();
    jacobian.block<3, 3>(0, 0) = r;
    jacobian.block<1, 3>(3, 0) = support::eigen(motion.t).transpose() * r;
    const Eigen::Matrix4d expected = jacobian * support::covariance_4x4_of(fit) * jacobian.transpose();
    CHECK((support::covariance_4x4_of(there) - expected).cwiseAbs().maxCoeff() < 1e-11 * expected.maxCoeff());
  }
  CHECK(turned > 20);
}
