// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fixture_frames.hpp"
#include "straightedge/plane.hpp"
#include "straightedge/points_view.hpp"

namespace compare {

struct Points {
  std::vector<float> x, y, z;
  std::int32_t width = 0;  ///< of the picture they come from; 0: no order

  std::size_t size() const { return x.size(); }
  void add(const straightedge::Vector3& point);
  straightedge::Vector3 at(std::size_t i) const { return view().at(i); }
  straightedge::PointsView view() const;
};

/// A depth frame in the forms in which libraries want it.
struct Scene {
  std::string name;
  bench::FixtureFrame frame;
  Points picture;                          ///< a point a pixel, not a number where there is no reading
  Points cloud;                            ///< the readings alone
  std::vector<straightedge::Plane> truth;  ///< in the camera's frame, where it is known
};

/// The shipped frame of an office, and the first of the room.
std::vector<Scene> scenes();

/// The direction of the surface at each point of a cloud, towards the origin, from its 16 nearest.
Points normals_of(const Points& cloud);

}  // namespace compare
