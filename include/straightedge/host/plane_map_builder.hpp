// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/detail/plane_run.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/plane_leaves.hpp"
#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

struct PlaneMapOptions {
  /// While frames are added: the noise of a reading, which gives its weight.
  PlaneGate gate;

  // While planes are read out.
  PlaneFloor floor;                 ///< what no number of readings averages away
  double reading_floor = 0.3;       ///< 0..10; such an error too, in standard deviations of one reading
  double shared_noise = 25;         ///< 1..1e6; neighbouring readings that have one noise in common
  double chi_square = 11.34;        ///< above 0; gate of "the same plane", 3 degrees of freedom
  double max_angle = 0.087;         ///< radians, 0..1; never joined beyond it, whatever the uncertainty
  double max_offset = 0.035;        ///< metres, 0..1; nor beyond this distance
  double copy_angle = 0.12;         ///< radians, 0..1; a plane that lies over another one, no farther askew
  double copy_offset = 0.06;        ///< metres, 0..1; and no farther off, is a copy of it
  std::uint64_t min_points = 1500;  ///< planes with fewer readings are dropped
  double max_tilt = 0.1;       ///< radians, 0..2; planes whose tilt is not known as well as this are dropped
  double max_residual = 1.58;  ///< sigma, above 0; planes that one frame saw are dropped beyond it,
  std::uint64_t sure_points = 15000;  ///< unless they have as many readings
  double min_area = 0.01;  ///< m², 0..1e6; planes with less extent are dropped, and so are such pieces of one
  double max_gap = 0.15;   ///< metres, 0..10; places without readings this narrow are closed
  double max_hole = 0.1;   ///< m², 0..1e6; smaller holes are closed
  bool polygons = true;    ///< extents too
};

/// Where the readings of one frame plane went: the leaves that took most of them.
struct PlaneAnchors {
  std::array<PlaneLeafKey, 8> leaves{};
  std::array<std::uint32_t, 8> readings{};
};

/// What became of a frame.
struct RegisteredFrame {
  std::uint64_t placed = 0;          ///< readings that are in the map now
  std::uint64_t off_plane = 0;       ///< labelled, but nowhere near their plane
  std::uint64_t out_of_range = 0;    ///< beyond the grid's ±131 km
  std::vector<PlaneAnchors> planes;  ///< one a frame plane
};

struct PlaneMapReport {
  std::uint64_t frames = 0;
  std::uint64_t readings = 0;  ///< in leaves
  std::uint64_t leaves = 0;
  std::uint32_t patches = 0;  ///< pieces of planes, of a metre's size
  std::uint32_t planes = 0;   ///< in the map
  std::uint32_t too_few = 0;  ///< dropped for few readings
  std::uint32_t fragments =
      0;  ///< dropped: broken off planes that every frame saw elsewhere for the most part
  std::uint32_t too_vague = 0;  ///< dropped for a tilt that nobody knows
  std::uint32_t too_rough = 0;  ///< dropped for readings that scatter too much
  std::uint32_t too_small = 0;  ///< dropped for a small extent
};

/// A plane map as it is read out of the leaves.
struct PlaneMapReading {
  PlaneMap map;
  PlaneMapReport report;

  struct LeafId {
    PlaneLeafKey key;
    std::uint32_t id = 0;
  };
  std::vector<LeafId> leaf_ids;  ///< by key; leaves of dropped planes are left out

  /// The map's plane that a frame plane became part of; 0: a dropped one.
  std::uint32_t plane_id(const PlaneAnchors& anchors) const;
};

/// Frames with labelled planes and known poses become one map of planes. docs/plane-map.md tells the steps
/// with pictures of what happens.
///
/// Adding a frame (time proportional to its pixels; nothing depends on the size of the map):
///  1. The readings of one plane in a square of 4x4 pixels become a bundle. It stands at the mean of their
///     pixels, where that one's ray meets the frame's plane, which was fitted in inverse depth and is
///     therefore better than any reading; how far each reading is off the plane is remembered as residual.
///  2. By the pose into the world, and onto the grid of plane_leaves.hpp.
///  3. Leaf and surface choose an entry; readings, weight, place and products are added to it as integers.
/// Reading planes out (time n log n in the number of leaves):
///  4. Leaves by key; surfaces of one block of 1 m that agree become patches.
///  5. Patches that are of one plane are joined, the strongest first, by chi-square with floors and caps;
///     copies of one surface are joined too.
///  6. Each plane is fitted to its sums; those with few readings, a vague tilt or wide scatter go.
///  7. Extents as polygons. 8. Order, ids.
///
/// Any order of frames, and any partition of them over builders that are merged, gives the same bytes.
class PlaneMapBuilder {
 public:
  /// All kernels give the same bits.
  explicit PlaneMapBuilder(const PlaneMapOptions& options = {}, const KernelSet& kernels = best_kernels())
      : options_(options), kernels_(kernels.plane_rows) {}

  /// `labels` has the size of the frame: 0 is no plane, k is planes[k − 1], which is given in the camera's
  /// frame. A frame that is refused leaves no trace: bad_option (options out of range), bad_content (views
  /// without pixels or of unequal size, a label without plane, a plane that is none, a pose that is no
  /// rotation or not finite, more readings in a leaf than 64 bits can sum: 2^32).
  Result<RegisteredFrame> add(const DepthView& depth, ImageView<const std::uint16_t> labels,
                              std::span<const FoundPlane> planes, const Pose& world_from_camera);

  /// A cloud, one label a point; readings move onto their plane along its normal. Frame: the sensor's, which
  /// stands at its origin.
  Result<RegisteredFrame> add(const PointsView& points, std::span<const std::uint16_t> labels,
                              std::span<const FoundPlane> planes, const Pose& world_from_sensor);

  /// Adds the other's leaves; its options do not matter. bad_content when a sum could overflow.
  Result<Done> merge(const PlaneMapBuilder& other) { return merge(other.leaves_); }
  Result<Done> merge(const PlaneLeaves& other);

  Result<PlaneMapReading> build() const;

  const PlaneLeaves& leaves() const noexcept { return leaves_; }
  const PlaneMapOptions& options() const noexcept { return options_; }

 private:
  PlaneMapOptions options_;
  const PlaneRowKernels* kernels_;
  PlaneLeaves leaves_;
  std::vector<detail::PlaneRun> runs_;  // memory of add, and where to look in it
  std::vector<std::uint32_t> slots_;
};

}  // namespace straightedge
