// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_key.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A frame's plane as the registration of its readings needs it.
struct FramePlane {
  Plane in_camera;
  Vector3 towards_camera;  ///< the normal in the world
  double offset = 0;       ///< towards_camera · place = offset, quanta of the grid
  GridNormal normal;       ///< towards_camera on the grid
  std::uint32_t direction = 0;
  std::int64_t tilt = 0;        ///< variance of the normal, in tilt_unit
  double weight_by_depth = 0;   ///< weight of a reading: weight_by_depth / z² + weight_anywhere
  double weight_anywhere = 0;
  bool counts = true;  ///< no plane of a lower index in this frame is the same one
};

/// Refuses a pose that is no rotation or not finite.
Result<Done> check_pose(const Pose& pose);

/// Refuses planes that are none.
Result<std::vector<FramePlane>> frame_planes(std::span<const FoundPlane> planes, const Pose& pose,
                                             const PlaneGate& gate);

/// Sums of neighbouring readings that go to one leaf and surface, kept out of the table while they last.
struct LeafRun {
  std::uint32_t label = 0;  ///< 0: empty
  LeafPlace place;
  PlaneLeafSums sums;

  /// `i`, `j`, `k` quanta of the grid; `w` weight, `r` quanta from the plane.
  void add(std::int32_t i, std::int32_t j, std::int32_t k, std::int64_t w, std::int64_t r) noexcept;
};

/// Puts runs into the leaves and remembers what the frame did.
class LeafWriter {
 public:
  LeafWriter(PlaneLeaves& leaves, std::vector<std::uint32_t>& tally, std::span<const FramePlane> planes)
      : leaves_(leaves), tally_(tally), planes_(planes) {}

  /// Empties the run. `spacing`: metres between neighbouring readings there, 0 when that is unknown.
  void put(LeafRun& run, double spacing);
  /// Counts sightings, finds the anchors, cleans the tally.
  RegisteredFrame finish();

 private:
  struct Touched {
    std::uint32_t place = 0, label = 0;
  };

  PlaneLeaves& leaves_;
  std::vector<std::uint32_t>& tally_;
  std::span<const FramePlane> planes_;
  std::vector<Touched> touched_;
};

}  // namespace straightedge
