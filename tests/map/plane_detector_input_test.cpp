// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>

#include "detector_testing.hpp"

using namespace detector;

namespace {

template <class T>
bool fails_with(const Result<T>& result, Problem problem) {
  return !result && result.failure().problem == problem && !result.failure().sentence.empty();
}

}  // namespace

TEST_CASE("options out of their range are refused before memory is taken for them") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](PlaneMethod method, auto&& change) {
    PlaneDetectorOptions options = by(method);
    change(options);
    return fails_with(PlaneDetector::create({64, 48}, options), Problem::bad_option);
  };
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    CHECK(refused(method, [](auto& o) { o.frame.max_planes = 0xFFFFFFFFU; }));
    CHECK(refused(method, [](auto& o) { o.frame.max_planes = 2000000; }));  // the table of pairs: 16 TB
    CHECK(refused(method, [](auto& o) { o.frame.max_planes = 0; }));
    CHECK(refused(method, [](auto& o) { o.frame.slack = nan; }));
    CHECK(refused(method, [](auto& o) { o.frame.rounds = 9; }));
    CHECK(refused(method, [](auto& o) { o.frame.gate.sigmas = -1; }));
    for (const Size size : {Size{0, 5}, Size{5, 0}, Size{-4, 5}, Size{1 << 16, 4}, Size{1 << 15, 1 << 15}}) {
      INFO(size.width << " x " << size.height);
      CHECK(fails_with(PlaneDetector::create(size, by(method)), Problem::bad_option));
    }
  }
  CHECK(refused(PlaneMethod::ransac, [](auto& o) { o.ransac.cell = 0; }));
  CHECK(refused(PlaneMethod::ransac, [](auto& o) { o.ransac.confidence = 1; }));
  CHECK(refused(PlaneMethod::hough, [](auto& o) { o.hough.rounds = 0; }));
}

TEST_CASE("frames that make no sense are refused") {
  const Size size{64, 48};
  const Image<std::uint16_t> raw(size, std::uint16_t{1500}), other({65, 48}, std::uint16_t{1500});
  const PinholeCamera camera = support::kinect(size);
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    auto detector = PlaneDetector::create(size, by(method));
    REQUIRE(detector);
    CHECK(detector->workspace_bytes() > 0);
    CHECK(detector->detect({raw, 0.001, camera}));
    CHECK(fails_with(detector->detect({other, 0.001, camera}), Problem::bad_content));
    CHECK(fails_with(detector->detect({{}, 0.001, camera}), Problem::bad_content));
    ImageView<const std::uint16_t> negative = raw;
    negative.width = -64;
    CHECK(fails_with(detector->detect({negative, 0.001, camera}), Problem::bad_content));
    CHECK(fails_with(detector->detect({raw, 0, camera}), Problem::bad_content));
    CHECK(fails_with(detector->detect({raw, 0.001, {0, 500, 32, 24}}), Problem::bad_content));
    CHECK(detector->detect({raw, 0.001, camera}));
  }
}

TEST_CASE("frames without planes give empty results, and one value everywhere a wall") {
  const Size size{160, 120};
  DepthFrame frame{Image<std::uint16_t>(size), support::kinect(size)};
  for (const PlaneMethod method : both_methods) {
    INFO(name_of(method));
    const DetectedPlanes none = detect(frame, by(method));
    CHECK(none.planes.empty());
    CHECK(none.found.readings == 0);
    CHECK(none.labels == Image<std::uint16_t>(size));
    const DepthFrame wall{Image<std::uint16_t>(size, std::uint16_t{1800}), frame.camera};
    const DetectedPlanes one = detect(wall, by(method));
    REQUIRE(one.planes.size() == 1);
    CHECK(one.found.labelled == 160U * 120U);
    CHECK(one.planes[0].fit.plane.distance == Approx(1.8).epsilon(1e-4));
  }
}
