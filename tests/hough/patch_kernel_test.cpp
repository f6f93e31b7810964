// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_votes.hpp"
#include "plane_scene.hpp"
#include "support/catch.hpp"

using namespace straightedge;

TEST_CASE("a vote's kernel is the chi-square of the slopes that a turned normal would have") {
  const std::uint64_t seed = 51;
  Pcg32 random(seed);
  for (int i = 0; i < 200; ++i) {
    const PinholeCamera camera{300 + 300 * test::uniform(random), -200 - 300 * test::uniform(random), 320,
                               240};
    // Cells so small that they add nothing to the kernel.
    const hough::PatchScene scene{{640, 480}, camera, {}, {.max_spread_rad = 1}, 1e-12, 0.1};
    HoughPatch patch;
    patch.mean_u = 640 * test::uniform(random);
    patch.mean_v = 480 * test::uniform(random);
    const Vector3 ray = camera.ray(patch.mean_u, patch.mean_v);
    Vector3 normal = test::random_direction(random);
    if (dot(normal, ray) < 0) normal = -normal;
    if (dot(normal, ray) < 0.1) continue;
    const Plane plane{normal, 0.5 + 3 * test::uniform(random)};
    patch.plane = to_inverse_depth(plane, camera);
    patch.mean_q = patch.plane.at(patch.mean_u, patch.mean_v);
    const double aa = 1e-10 * (1 + test::uniform(random)), bb = 1e-10 * (1 + test::uniform(random));
    const double ab = 0.8e-10 * (test::uniform(random) - 0.5);
    patch.slope_covariance = {aa, ab, bb};
    hough::shape_vote(scene, patch);
    INFO("seed " << seed << " patch " << i);
    CHECK(length(patch.space.normal - normal) < 1e-9);
    CHECK(plane.signed_distance(patch.point) == Approx(0).margin(1e-9));
    CHECK(hough::kernel_distance(patch, normal) < 1e-12);

    const Vector3 turned = normalized(normal + 1e-6 * test::random_direction(random));
    const InverseDepthPlane other = to_inverse_depth({turned, dot(turned, patch.point)}, camera);
    const double da = other.a - patch.plane.a, db = other.b - patch.plane.b;
    const double expected = (da * da * bb - 2 * da * db * ab + db * db * aa) / (aa * bb - ab * ab);
    CHECK(hough::kernel_distance(patch, turned) == Approx(expected).epsilon(1e-3));
  }
}
