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

/// Where a reading goes: quanta of the grid, and quanta from its plane.
struct GridReading {
  std::int32_t i = 0, j = 0, k = 0, residual = 0;

  MortonCell leaf() const noexcept {
    constexpr int bits = plane_grid::leaf_bits;
    return {static_cast<std::uint32_t>(i >> bits), static_cast<std::uint32_t>(j >> bits),
            static_cast<std::uint32_t>(k >> bits)};
  }
  bool same_leaf(const GridReading& o) const noexcept {
    return static_cast<std::uint32_t>((i ^ o.i) | (j ^ o.j) | (k ^ o.k)) < plane_grid::leaf_side;
  }
};
inline constexpr std::int32_t most_residual = 1 << 20;  ///< quanta, 256 m

/// Readings of one plane that go to one leaf, summed in short integers and without their weight.
struct LeafRun {
  std::uint32_t label = 0;  ///< 0: empty
  GridReading first;
  std::int32_t readings = 0;
  std::int32_t x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  std::int64_t residual = 0;

  static constexpr std::int32_t most_readings = 1 << 15;  ///< of 2^14 each: the sums stay below 2^30
};

/// From where a frame was taken.
struct Viewpoint {
  Pose world_from_camera;
  double focal = 0;  ///< pixels; 0: neighbouring readings are not known
};

/// Puts runs into the leaves and remembers what the frame did.
class LeafWriter {
 public:
  LeafWriter(PlaneLeaves& leaves, std::vector<std::uint32_t>& tally, std::span<const FramePlane> planes,
             const Viewpoint& view)
      : leaves_(leaves), tally_(tally), planes_(planes), view_(view) {}

  /// Adds the run, if it is one, to its leaf.
  void put(const LeafRun& run);
  /// Counts sightings, finds the anchors, cleans the tally.
  RegisteredFrame finish();

 private:
  struct Touched {
    std::uint32_t place = 0, label = 0;
  };

  PlaneLeaves& leaves_;
  std::vector<std::uint32_t>& tally_;
  std::span<const FramePlane> planes_;
  Viewpoint view_;
  std::vector<Touched> touched_;
};

}  // namespace straightedge
