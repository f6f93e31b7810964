// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/cloud_input.hpp"
#include "budget/depth_input.hpp"

namespace firmware {
namespace {

struct Point {
  float x = 0, y = 0, z = 0;
};

[[gnu::section(".big.points")]] std::array<Point, most_points> cloud;

}  // namespace

straightedge::PointsView room_points(straightedge::Size size) noexcept {
  const straightedge::DepthView depth = room_depth(size);
  std::size_t count = 0;
  for (std::int32_t y = 0; y < size.height; y += 4) {
    for (std::int32_t x = 0; x < size.width; x += 4) {
      const straightedge::Vector3 p = (depth.raw.at(x, y) * depth.metres_per_unit) * depth.camera.ray(x, y);
      cloud[count++] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
  }
  return {&cloud[0].x, &cloud[0].y, &cloud[0].z, count, sizeof(Point)};
}

}  // namespace firmware
