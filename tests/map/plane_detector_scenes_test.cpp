// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <vector>

#include "detector_testing.hpp"

using namespace detector;

namespace {

constexpr Size size{320, 240};

}  // namespace

TEST_CASE("both methods find the walls of a box room, whatever the noise") {
  const auto planes = support::box_planes();
  const DepthScene scene = support::box_room(size, planes);
  for (const PlaneMethod method : both_methods) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      INFO(name_of(method) << ", seed " << seed);
      const DepthFrame frame = support::frame_of(scene, {}, seed);
      const DetectedPlanes result = detect(frame, by(method));
      check_planes(result, planes);
      CHECK(support::agreement(result.labels, frame.raw, scene.truth()) > 0.98);
      CHECK(result.found.planes == result.planes.size());
      CHECK(result.found.iterations > 0);
    }
  }
}

TEST_CASE("both methods find the same walls with 60 percent of holes") {
  const auto planes = support::box_planes();
  const DepthScene scene = support::box_room({640, 480}, planes);
  for (const PlaneMethod method : both_methods) {
    for (const int side : {1, 3, 11}) {
      SensorNoise noise;
      noise.holes = 0.6;
      noise.hole_side = side;
      INFO(name_of(method) << ", holes of " << side << " pixels");
      const DepthFrame frame = support::frame_of(scene, noise, 5);
      const DetectedPlanes result = detect(frame, by(method));
      check_planes(result, planes);
      CHECK(support::agreement(result.labels, frame.raw, scene.truth()) > 0.97);
    }
  }
}

TEST_CASE("a threshold in metres decides which planes are told apart") {
  const Vector3 normal = normalized({0.1, -0.05, 1});
  const Plane near{normal, 1.5}, far{normal, 1.54};
  DepthScene scene(size);
  scene.draw_plane(1, far);
  scene.draw_part(2, near, [](const Vector3& p) { return p.x < 0; });
  const DepthFrame frame = support::frame_of(scene, {}, 3);
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    PlaneDetectorOptions options = by(method);
    check_planes(detect(frame, options), {near, far});
    options.frame.gate.fixed_m = 0.015;
    check_planes(detect(frame, options), {near, far});
    options.frame.gate.fixed_m = 0.2;
    const DetectedPlanes one = detect(frame, options);
    CHECK(one.planes.size() == 1);
    CHECK(one.found.labelled > 0.98 * one.found.readings);
  }
}

TEST_CASE("readings further from the plane than the threshold are not labelled") {
  const Plane wall{normalized({0.1, -0.05, 1}), 1.5};
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  DepthFrame frame = support::frame_of(scene, {}, 3);
  for (int y = 0; y < size.height; y += 7) {
    for (int x = 0; x < size.width; x += 9)
      frame.raw.at(x, y) = static_cast<std::uint16_t>(frame.raw.at(x, y) + 40);
  }
  for (const PlaneMethod method : both_methods) {
    for (const double fixed_m : {0.02, 0.08}) {
      INFO(name_of(method) << ", threshold " << fixed_m);
      PlaneDetectorOptions options = by(method);
      options.frame.gate.fixed_m = fixed_m;
      const DetectedPlanes result = detect(frame, options);
      REQUIRE(result.planes.size() == 1);
      int spikes = 0, labelled = 0;
      for (int y = 0; y < size.height; y += 7) {
        for (int x = 0; x < size.width; x += 9) {
          ++spikes;
          labelled += result.labels.at(x, y) != 0 ? 1 : 0;
        }
      }
      CHECK((fixed_m > 0.04 ? labelled > 0.97 * spikes : labelled < 0.03 * spikes));
    }
  }
}

TEST_CASE("a wall whose picture sags by some deviations is one plane") {
  const Plane wall{normalized({0.1, 0, 1}), 2};
  DepthScene scene({640, 480});
  scene.draw_plane(1, wall);
  for (const PlaneMethod method : both_methods) {
    for (const double deviations : {-9.0, -3.0, 3.0, 9.0}) {
      SensorNoise noise;
      noise.sag = deviations * 1.425e-3;
      INFO(name_of(method) << ", sag " << noise.sag);
      const DetectedPlanes result = detect(support::frame_of(scene, noise, 4), by(method));
      CHECK(result.planes.size() == 1);
      CHECK(result.found.labelled > 0.98 * result.found.readings);
    }
  }
}
