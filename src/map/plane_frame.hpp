// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_key.hpp"
#include "straightedge/detail/plane_run.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/morton.hpp"

namespace straightedge {

/// A frame's plane as the registration of its readings needs it.
struct FramePlane {
  Plane in_camera;
  Vector3 towards_camera;  ///< the normal in the world
  double offset = 0;       ///< towards_camera · x = offset, metres
  GridNormal normal;       ///< towards_camera on the grid
  std::uint32_t direction = 0;
  std::int64_t tilt = 0;       ///< variance of the normal, in tilt_unit
  double weight_by_depth = 0;  ///< weight of a reading: weight_by_depth / z² + weight_anywhere
  double weight_anywhere = 0;
  bool counts = true;  ///< no plane of a lower index in this frame is the same one
};

/// Refuses a pose that is no rotation or not finite.
Result<Done> check_pose(const Pose& pose);

/// Refuses planes that are none.
Result<std::vector<FramePlane>> frame_planes(std::span<const FoundPlane> planes, const Pose& pose,
                                             const PlaneGate& gate);

/// From where a frame was taken.
struct Viewpoint {
  Pose world_from_camera;
  double focal = 0;  ///< pixels; 0: neighbouring readings are not known
};

/// Puts a frame's runs into the leaves.
class LeafWriter {
 public:
  LeafWriter(PlaneLeaves& leaves, std::span<const FramePlane> planes, const Viewpoint& view)
      : leaves_(leaves), planes_(planes), view_(view), forward_(view.world_from_camera.turned({0, 0, 1})) {}

  /// Adds every run to its leaf, finds the anchors, counts sightings.
  RegisteredFrame put(std::span<const detail::PlaneRun> runs);

 private:
  struct Target {
    PlaneLeafKey key;
    double depth = 0;
  };

  Target target_of(const detail::PlaneRun& run) const;
  void put(const detail::PlaneRun& run, const Target& target);

  PlaneLeaves& leaves_;
  std::span<const FramePlane> planes_;
  Viewpoint view_;
  Vector3 forward_;
};

}  // namespace straightedge
