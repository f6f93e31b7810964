// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include "plane_error.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

constexpr int trials = 3000;
// The mean of `trials` chi-square numbers of 3 degrees of freedom scatters by sqrt(6 / trials), a share p of
// events by sqrt(p (1 − p) / trials). Four of those: one seed in 16 000 would fail by chance.
const double mean_tolerance = 4 * std::sqrt(6.0 / trials);
const double share_tolerance = 4 * std::sqrt(0.01 * 0.99 / trials);

struct Patch {
  Vector3 centre, u, v, normal;
};

/// A patch 2 to 3.5 m from the origin, tilted by up to 60 degrees against the way to it.
Patch random_patch(Pcg32& random) {
  const Vector3 along =
      normalized({support::uniform(random, -0.5, 0.5), support::uniform(random, -0.4, 0.4), 1});
  const double tilt = support::uniform(random, 0, 60 * degree), turn = support::uniform(random, -pi, pi);
  const Vector3 aside = normalized(cross(along, {0, 1, 0}));
  const Vector3 lean = std::cos(turn) * aside + std::sin(turn) * cross(along, aside);
  const Vector3 normal = std::cos(tilt) * along + std::sin(tilt) * lean;
  const Vector3 u = normalized(cross(normal, {0, 1, 0}));
  return {support::uniform(random, 2, 3.5) * along, u, cross(normal, u), normal};
}

Plane plane_of(const Patch& patch) {
  return canonical({patch.normal, dot(patch.normal, patch.centre)});
}

/// Points from `from` to `to` along u, each with noise of its own along the normal.
PlaneMoments noisy_moments(const Patch& patch, double from, double to, int count, Pcg32& random) {
  PlaneMoments moments;
  for (int i = 0; i < count; ++i) {
    const double sigma = support::uniform(random, 0.004, 0.02);
    moments.add(patch.centre + support::uniform(random, from, to) * patch.u +
                    support::uniform(random, -0.3, 0.3) * patch.v +
                    sigma * support::normal(random) * patch.normal,
                1 / (sigma * sigma));
  }
  return moments;
}

PlaneFit fit_of(const PlaneMoments& moments) {
  PlaneFit fit;
  REQUIRE(fit_plane(moments, fit) == Status::ok);
  return fit;
}

PlaneFit noisy_fit(const Patch& patch, double from, double to, Pcg32& random) {
  return fit_of(noisy_moments(patch, from, to, 100, random));
}

struct Motion {
  std::array<double, 9> rotation{};
  Vector3 t;

  Vector3 operator()(const Vector3& p) const {
    const auto& r = rotation;
    return Vector3{r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
                   r[6] * p.x + r[7] * p.y + r[8] * p.z} +
           t;
  }
};

Motion random_motion(Pcg32& random) {
  const Eigen::Vector3d axis(support::normal(random), support::normal(random), support::normal(random));
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(support::uniform(random, -pi, pi), axis.normalized()).toRotationMatrix();
  return {
      {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)},
      {support::uniform(random, -9, 9), support::uniform(random, -9, 9), support::uniform(random, -9, 9)}};
}

void check_same_covariance(const PlaneFit& a, const PlaneFit& b, double tolerance) {
  const auto left = covariance_4x4(a), right = covariance_4x4(b);
  double largest = 0;
  for (const double entry : right) largest = std::max(largest, std::fabs(entry));
  for (std::size_t i = 0; i < left.size(); ++i) {
    CHECK(left[i] == Approx(right[i]).margin(tolerance * largest));
  }
}

struct Gated {
  double mean = 0, rejected = 0;
};

template <class Draw>
Gated gate_of(Draw&& draw) {
  Gated gated;
  for (int i = 0; i < trials; ++i) {
    const double distance = draw();
    gated.mean += distance / trials;
    gated.rejected += distance > 11.34 ? 1.0 / trials : 0;
  }
  return gated;
}

}  // namespace

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

TEST_CASE("two patches of one plane pass the test as often as they should") {
  constexpr std::uint64_t seed = 62;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Gated gated = gate_of([&] {
    const Patch patch = random_patch(random);
    return plane_chi_square(noisy_fit(patch, -0.9, 0.1, random), noisy_fit(patch, 0.2, 1, random));
  });
  CHECK(gated.mean == Approx(3).margin(mean_tolerance));
  CHECK(gated.rejected == Approx(0.01).margin(share_tolerance));
}

TEST_CASE("two views of one plane pass the test in either's frame") {
  constexpr std::uint64_t seed = 63;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Gated gated = gate_of([&] {
    const Patch patch = random_patch(random);
    const Motion motion = random_motion(random);
    const PlaneFit a = noisy_fit(patch, -0.9, 0.1, random);
    const PlaneFit b = noisy_fit(patch, 0.2, 1, random);
    const PlaneFit moved_a = moved(a, motion.rotation, motion.t);
    const PlaneFit moved_b = moved(b, motion.rotation, motion.t);
    const double distance = plane_chi_square(moved_a, moved_b);
    CHECK(distance == Approx(plane_chi_square(a, b)).epsilon(1e-6));
    CHECK(distance == Approx(plane_chi_square(moved_b, moved_a)).epsilon(0.01).margin(0.01));
    return distance;
  });
  CHECK(gated.mean == Approx(3).margin(mean_tolerance));
  CHECK(gated.rejected == Approx(0.01).margin(share_tolerance));
}

TEST_CASE("planes that differ do not pass, and infinity stands for no answer") {
  constexpr std::uint64_t seed = 64;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Patch patch = random_patch(random);
  Patch behind = patch;
  behind.centre = behind.centre + 0.1 * patch.normal;
  const PlaneFit fit = noisy_fit(patch, -0.4, 0.4, random);
  CHECK(plane_chi_square(fit, noisy_fit(behind, -0.4, 0.4, random)) > 100);
  // A floor for sensor and poses makes them one wall again.
  PlaneFit rough = noisy_fit(behind, -0.4, 0.4, random);
  add_floor(rough, {3 * degree, 0.1});
  CHECK(plane_chi_square(fit, rough) < 11.34);
  CHECK(plane_chi_square(fit, fit) == 0);
  PlaneFit certain = fit, elsewhere = fit;
  certain.covariance = {};
  elsewhere.covariance = {};
  CHECK(plane_chi_square(certain, elsewhere) == 0);
  elsewhere.plane.distance += 1;
  CHECK(plane_chi_square(certain, elsewhere) == HUGE_VAL);
  PlaneFit broken = fit;
  broken.plane.distance = std::nan("");
  CHECK(plane_chi_square(fit, broken) == HUGE_VAL);
  broken = noisy_fit(patch, -0.4, 0.4, random);
  broken.covariance[5] = std::nan("");
  CHECK(plane_chi_square(fit, broken) == HUGE_VAL);
}

TEST_CASE("normals that point to opposite sides are one plane's all the same") {
  constexpr std::uint64_t seed = 65;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const Patch patch = random_patch(random);
    const PlaneFit a = noisy_fit(patch, -0.9, 0.1, random);
    const PlaneFit b = noisy_fit(patch, 0.2, 1, random);
    // From an origin that noise puts now before, now behind the plane.
    const std::array<double, 9> same{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const PlaneFit near_a = moved(a, same, -patch.centre);
    const PlaneFit near_b = moved(b, same, -patch.centre);
    CHECK(plane_chi_square(near_a, near_b) == Approx(plane_chi_square(a, b)).epsilon(1e-6));
    CHECK(near_a.plane == canonical(near_a.plane));
    CHECK(length(cross(near_b.tangent_u, near_b.tangent_v) - near_b.plane.normal) < 1e-14);
  }
}

TEST_CASE("fusing two fits is fitting all their points") {
  constexpr std::uint64_t seed = 66;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const Patch patch = random_patch(random);
    PlaneMoments a = noisy_moments(patch, -0.9, 0.1, 400, random);
    const PlaneMoments b = noisy_moments(patch, 0.2, 1, 200, random);
    PlaneFit fused;
    REQUIRE(fuse_planes(fit_of(a), fit_of(b), fused) == Status::ok);
    a.add(b);
    const PlaneFit batch = fit_of(a);
    CHECK(support::angle_between(fused.plane.normal, batch.plane.normal) < 0.005 * degree);
    CHECK(fused.plane.distance == Approx(batch.plane.distance).margin(2e-4));
    CHECK(length(fused.centroid - batch.centroid) < 1e-9);
    CHECK(fused.weight == Approx(batch.weight));
    CHECK(fused.count == batch.count);
    CHECK(fused.plane == canonical(fused.plane));
    check_same_covariance(fused, batch, 0.02);
  }
}

TEST_CASE("fused planes are as uncertain as they say") {
  constexpr std::uint64_t seed = 67;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Gated gated = gate_of([&] {
    const Patch patch = random_patch(random);
    PlaneFit fused;
    REQUIRE(fuse_planes(noisy_fit(patch, -0.9, 0.1, random), noisy_fit(patch, 0.2, 1, random), fused) ==
            Status::ok);
    return support::nees(fused, plane_of(patch));
  });
  CHECK(gated.mean == Approx(3).margin(mean_tolerance));
}

TEST_CASE("nothing is fused without covariances") {
  constexpr std::uint64_t seed = 68;
  CAPTURE(seed);
  Pcg32 random(seed);
  const PlaneFit fit = noisy_fit(random_patch(random), -0.4, 0.4, random);
  for (std::size_t entry = 0; entry < 6; ++entry) {
    for (const double bad : {std::nan(""), HUGE_VAL}) {
      PlaneFit broken = fit, fused;
      fused.count = -5;
      broken.covariance[entry] = bad;
      CHECK(fuse_planes(fit, broken, fused) == Status::invalid_option);
      CHECK(fuse_planes(broken, fit, fused) == Status::invalid_option);
      CHECK(fused.count == -5);
    }
  }
  PlaneFit certain = fit, fused;
  certain.covariance = {};
  CHECK(fuse_planes(fit, certain, fused) == Status::invalid_option);
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
