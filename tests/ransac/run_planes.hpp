// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene.hpp"
#include "straightedge/ransac_planes.hpp"
#include "support/catch.hpp"

namespace scene {

struct FoundPlanes {
  RansacPlanesResult result;
  std::vector<FoundPlane> planes;
  std::vector<std::uint16_t> labels;
};

inline RansacPlanes prepared(std::size_t readings, const RansacOptions& options,
                             std::vector<std::byte>& workspace) {
  workspace.resize(RansacPlanes::workspace_bytes(readings, options));
  RansacPlanes object;
  REQUIRE(RansacPlanes::prepare(object, readings, options, workspace) == Status::ok);
  return object;
}

inline FoundPlanes find(const PointsView& points, const RansacOptions& options, std::size_t room = 64) {
  std::vector<std::byte> workspace;
  RansacPlanes object = prepared(points.count > 0 ? points.count : 1, options, workspace);
  FoundPlanes found;
  found.planes.resize(room);
  found.labels.assign(points.count, 999);
  found.result = object.run(points, found.planes, found.labels);
  found.planes.resize(found.result.found.planes);
  return found;
}

inline FoundPlanes find(const Frame& frame, const RansacOptions& options, std::size_t room = 64) {
  std::vector<std::byte> workspace;
  RansacPlanes object = prepared(frame.q.size(), options, workspace);
  FoundPlanes found;
  found.planes.resize(room);
  found.labels.assign(frame.q.size(), 999);
  found.result = object.run(frame.view(), camera, found.planes, {found.labels.data(), size});
  found.planes.resize(found.result.found.planes);
  return found;
}

/// Points of a square of 2 half metres on the plane z = 0 of a frame that (a, b, normal at p) spans.
inline void add_square(Cloud& cloud, const Vector3& p, const Vector3& a, const Vector3& b, int steps,
                       double half) {
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const Vector3 at =
          p + (half * (2.0 * i / (steps - 1) - 1)) * a + (half * (2.0 * j / (steps - 1) - 1)) * b;
      cloud.x.push_back(static_cast<float>(at.x));
      cloud.y.push_back(static_cast<float>(at.y));
      cloud.z.push_back(static_cast<float>(at.z));
    }
}

}  // namespace scene
