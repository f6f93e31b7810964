// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "plane_scene.hpp"
#include "straightedge/hough_planes.hpp"

namespace test {

using namespace straightedge;

/// A search with its memory, and what it found.
struct CloudFound {
  Status status = Status::not_prepared;
  std::vector<std::byte> memory;
  std::unique_ptr<HoughPlanes> search;
  std::vector<std::uint16_t> labels;
  std::vector<FoundPlane> planes;
  PlanesFound found;
};

inline CloudFound find_planes(const PointsView& points, const HoughPlaneOptions& options = {},
                              std::size_t room = 64, HoughPlaneTrace trace = {}) {
  CloudFound result;
  result.memory.resize(HoughPlanes::workspace_bytes(points.count, options));
  result.search = std::make_unique<HoughPlanes>();
  result.status = HoughPlanes::prepare(*result.search, points.count, options, result.memory);
  if (result.status != Status::ok) return result;
  result.labels.resize(points.count, 99);
  result.planes.resize(room);
  result.status = result.search->run(points, result.labels, result.planes, result.found, trace);
  result.planes.resize(result.found.planes);
  return result;
}

inline HoughPlaneOptions options_for(HoughPlaneVoting voting) {
  HoughPlaneOptions options;
  options.voting = voting;
  options.accumulator = {HoughCells::ball, 30, 64};
  options.every = 4;
  return options;
}

inline bool has(const CloudFound& found, const Plane& plane, double angle_rad, double distance_m) {
  for (const FoundPlane& own : found.planes) {
    const double off = own.fit.plane.distance - plane.distance;
    if (angle_between(own.fit.plane.normal, plane.normal) < angle_rad && off < distance_m &&
        off > -distance_m)
      return true;
  }
  return false;
}

/// Three walls of a corner and a table top, each with its own number of points, and strays.
inline Cloud corner(std::uint64_t seed, const Vector3& at = {}, double noise = 0.003) {
  Pcg32 random(seed);
  Cloud cloud;
  cloud.add_disc(at + Vector3{0, 0, 3}, {0, 0, 1}, 1.5, 5000, noise, random);
  cloud.add_disc(at + Vector3{0, 1.2, 2}, {0, 1, 0}, 1.2, 4000, noise, random);
  cloud.add_disc(at + Vector3{1.8, 0, 2}, {1, 0, 0}, 1.0, 3000, noise, random);
  cloud.add_disc(at + Vector3{0.2, 0.5, 1.8}, normalized({0.3, 1, 0.2}), 0.5, 1500, noise, random);
  for (int i = 0; i < 1000; ++i) {
    cloud.add(at + Vector3{4 * uniform(random) - 2, 3 * uniform(random) - 1.5, 4 * uniform(random)});
  }
  return cloud;
}

inline bool has_corner(const CloudFound& found, const Vector3& at = {}, double distance_m = 0.006) {
  const auto plane = [&](const Vector3& n, const Vector3& p) {
    return plane_of(n, dot(normalized(n), p + at));
  };
  return has(found, plane({0, 0, 1}, {0, 0, 3}), 0.004, distance_m) &&
         has(found, plane({0, 1, 0}, {0, 1.2, 2}), 0.004, distance_m) &&
         has(found, plane({1, 0, 0}, {1.8, 0, 2}), 0.004, distance_m) &&
         has(found, plane({0.3, 1, 0.2}, {0.2, 0.5, 1.8}), 0.01, distance_m);
}

}  // namespace test
