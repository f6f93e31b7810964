// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <open3d/geometry/PointCloud.h>

#include <memory>

#include "peers.hpp"

namespace compare {

FindPlanes open3d_first_plane(const Scene& scene) {
  auto cloud = std::make_shared<open3d::geometry::PointCloud>();
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    const straightedge::Vector3 p = scene.cloud.at(i);
    cloud->points_.emplace_back(p.x, p.y, p.z);
  }
  return [cloud] {
    constexpr int sample = 3, iterations = 1000;
    constexpr double confidence = 0.99;
    const auto [plane, inliers] = cloud->SegmentPlane(gate_m, sample, iterations, confidence);
    if (inliers.empty()) return PlanesOfScene();
    return PlanesOfScene{{{{plane[0], plane[1], plane[2]}, -plane[3]}}, inliers.size()};
  };
}

}  // namespace compare
