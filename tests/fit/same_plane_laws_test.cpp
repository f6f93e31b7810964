// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "noisy_patch.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using namespace noisy;

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
