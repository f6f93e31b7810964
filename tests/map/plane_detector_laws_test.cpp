// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <vector>

#include "detector_testing.hpp"

using namespace detector;

namespace {

constexpr Size size{320, 240};

struct Room {
  std::vector<Plane> planes = support::box_planes();
  DepthScene scene = support::box_room(size, planes);
};

void check_same(const DetectedPlanes& a, const DetectedPlanes& b) {
  CHECK(labels_that_differ(a.labels, b.labels) == 0);
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t k = 0; k < a.planes.size(); ++k) {
    CHECK(a.planes[k].fit.plane == b.planes[k].fit.plane);
    CHECK(a.planes[k].fit.covariance == b.planes[k].fit.covariance);
    CHECK(a.planes[k].score == b.planes[k].score);
    CHECK(a.planes[k].inliers == b.planes[k].inliers);
  }
}

}  // namespace

TEST_CASE("the same frame and seed give the same result; another seed is another search") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 2), other = support::frame_of(room.scene, {}, 3);
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    PlaneDetectorOptions options = by(method);
    options.ransac.seed = 77;
    auto detector = PlaneDetector::create(size, options);
    REQUIRE(detector);
    const auto run = [&](const DepthFrame& f) {
      auto result = detector->detect(f.view());
      REQUIRE(result);
      return std::move(*result);
    };
    const DetectedPlanes first = run(frame);
    CHECK(first.found.seed == (method == PlaneMethod::ransac ? 77U : 0U));
    CHECK(labels_that_differ(run(other).labels, first.labels) > 0);
    check_same(first, run(frame));  // nothing is left of the frame between
    check_same(first, detect(frame, options));
    options.ransac.seed = 78;
    const DetectedPlanes again = detect(frame, options);
    check_planes(again, room.planes);
    if (method == PlaneMethod::ransac) {
      bool same_scores = first.planes.size() == again.planes.size();
      for (std::size_t k = 0; same_scores && k < first.planes.size(); ++k) {
        same_scores = first.planes[k].score == again.planes[k].score;
      }
      CHECK(!same_scores);
    }
  }
}

TEST_CASE("the unit of the readings does not matter") {
  const Room room;
  const DepthFrame millimetres = support::frame_of(room.scene, {}, 6);
  DepthFrame fifths = millimetres;
  fifths.metres_per_unit = 1.0 / 5000;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x)
      fifths.raw.at(x, y) = static_cast<std::uint16_t>(5 * fifths.raw.at(x, y));
  }
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    check_same(detect(millimetres, by(method)), detect(fifths, by(method)));
    SensorNoise noise;
    noise.units_per_metre = 5000;  // the same scene, rounded more finely
    check_planes(detect(support::frame_of(room.scene, noise, 6), by(method)), room.planes);
  }
}

TEST_CASE("a negative focal length gives the mirrored planes") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 8);
  for (const PlaneMethod method : both_methods) {
    const DetectedPlanes plain = detect(frame, by(method));
    check_planes(plain, room.planes);
    for (const bool across : {false, true}) {
      INFO(name_of(method) << (across ? ", fx" : ", fy"));
      DepthFrame turned = frame;
      (across ? turned.camera.fx : turned.camera.fy) *= -1;
      std::vector<Plane> mirrored = room.planes;
      for (Plane& plane : mirrored) (across ? plane.normal.x : plane.normal.y) *= -1;
      const DetectedPlanes result = detect(turned, by(method));
      check_planes(result, mirrored);
      const int differ = labels_that_differ(result.labels, plain.labels);
      CHECK(differ <= (method == PlaneMethod::ransac ? 0 : size.width * size.height / 50));
    }
  }
}
