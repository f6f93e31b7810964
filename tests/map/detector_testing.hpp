// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "straightedge/host/plane_detector.hpp"
#include "support/catch.hpp"
#include "support/depth_scene.hpp"
#include "support/depth_score.hpp"

namespace detector {

using namespace straightedge;
using support::DepthFrame;
using support::DepthScene;
using support::SensorNoise;

inline constexpr PlaneMethod both_methods[] = {PlaneMethod::ransac, PlaneMethod::hough};

inline const char* name_of(PlaneMethod method) {
  return method == PlaneMethod::ransac ? "ransac" : "hough";
}

inline PlaneDetectorOptions by(PlaneMethod method) {
  PlaneDetectorOptions options;
  options.method = method;
  return options;
}

inline DetectedPlanes detect(const DepthFrame& frame, const PlaneDetectorOptions& options) {
  auto result = detect_planes(frame.view(), options);
  REQUIRE(result);
  return std::move(*result);
}

inline int labels_that_differ(const Image<std::uint16_t>& a, const Image<std::uint16_t>& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += a.at(x, y) != b.at(x, y) ? 1 : 0;
  }
  return count;
}

inline void check_planes(const DetectedPlanes& result, const std::vector<Plane>& truth) {
  CHECK(result.planes.size() == truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    INFO("plane " << k);
    CHECK(support::count_of(result.planes, truth[k]) == 1);
  }
}

}  // namespace detector
