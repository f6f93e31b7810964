// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_map_builder.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "map/plane_export.hpp"
#include "map/plane_frame.hpp"
#include "map/plane_groups.hpp"
#include "map/plane_options.hpp"
#include "map/plane_order.hpp"
#include "map/plane_outline.hpp"
#include "map/plane_register.hpp"

namespace straightedge {
namespace {

Failure refusal(const char* sentence) {
  return {Problem::bad_content, sentence};
}

Result<Done> check_labels(std::uint32_t largest, std::size_t planes) {
  if (largest <= planes) return Done{};
  return Failure{Problem::bad_content, "label " + std::to_string(largest) + " of the frame has no plane"};
}

Result<std::vector<FramePlane>> prepare_frame(const PlaneMapOptions& options, const PlaneLeaves& leaves,
                                              std::uint64_t readings, std::span<const FoundPlane> planes,
                                              const Pose& pose) {
  if (const auto good = check_options(options); !good) return good.failure();
  if (const auto good = check_pose(pose); !good) return good.failure();
  if (leaves.fullest() + readings > plane_grid::most_readings)
    return refusal("a leaf of the plane map cannot sum more readings");
  return frame_planes(planes, pose, options.gate);
}

struct Candidate {
  MapPlane plane;
  std::vector<std::uint32_t> leaves;
};

/// The leaves of each group in the order of leaves.
std::vector<std::vector<std::uint32_t>> leaves_of(std::span<const PlaneGroup> groups,
                                                  std::span<const PlanePatch> patches, std::size_t leaves) {
  std::vector<std::uint32_t> group_of(leaves, 0);
  std::vector<std::vector<std::uint32_t>> of_groups(groups.size());
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    std::size_t count = 0;
    for (const std::uint32_t p : groups[g].patches) {
      for (const std::uint32_t i : patches[p].leaves) group_of[i] = g;
      count += patches[p].leaves.size();
    }
    of_groups[g].reserve(count);
  }
  for (std::uint32_t i = 0; i < leaves; ++i) of_groups[group_of[i]].push_back(i);
  return of_groups;
}

/// Of the worse one of the two tilts, without the floor, which is there however many readings come.
double tilt_variance(const SurfaceEstimate& e, const PlaneMapOptions& options) {
  return std::max(e.var_u, e.var_v) - options.floor.angle_rad * options.floor.angle_rad;
}

/// A chance plane through clutter: its readings fill the detector's gate instead of crowding about the plane,
/// and no second frame found it. A large one is a wall that the camera's distortion bends.
bool is_clutter(const Surface& s, const PlaneMapOptions& options) {
  const double count = s.moments.count;
  return s.sightings < 2 && s.residual > options.max_residual * options.max_residual * count &&
         count < static_cast<double>(options.sure_points);
}

/// Step 7. False for an extent that is too small.
bool outline(Candidate& c, std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options) {
  const PlaneChart chart(c.plane.plane, c.plane.moments->mean);
  const auto loops = extent_loops(covered_by(chart, leaves, c.leaves), extent_options(options));
  double area = 0;
  for (const ExtentLoop& loop : loops) area += loop.area;
  c.plane.polygons = polygons_of(chart, loops);
  return area >= options.min_area;
}

}  // namespace

Result<RegisteredFrame> PlaneMapBuilder::add(const DepthView& depth, ImageView<const std::uint16_t> labels,
                                             std::span<const FoundPlane> planes,
                                             const Pose& world_from_camera) {
  if (!depth.valid() || !labels.valid()) return refusal("the frame has no pixels or no camera");
  if (depth.raw.size() != labels.size()) return refusal("the frame and its labels differ in size");
  const auto pixels = static_cast<std::uint64_t>(labels.width) * static_cast<std::uint64_t>(labels.height);
  const auto ready = prepare_frame(options_, leaves_, pixels, planes, world_from_camera);
  if (!ready) return ready.failure();
  const double focal = std::min(std::abs(depth.camera.fx), std::abs(depth.camera.fy));
  PlaneRuns runs(runs_, slots_);
  const PlaneRowCounts counts = register_depth(depth, labels, *ready, world_from_camera, runs, *kernels_);
  if (const auto good = check_labels(counts.largest_label, planes.size()); !good) return good.failure();
  RegisteredFrame frame = LeafWriter(leaves_, *ready, {world_from_camera, focal}).put(runs.all());
  frame.off_plane = counts.labelled - counts.near_plane;
  frame.out_of_range = counts.out_of_range;
  return frame;
}

Result<RegisteredFrame> PlaneMapBuilder::add(const PointsView& points, std::span<const std::uint16_t> labels,
                                             std::span<const FoundPlane> planes,
                                             const Pose& world_from_sensor) {
  if (!points.valid()) return refusal("the cloud has no points");
  if (points.count != labels.size()) return refusal("the cloud and its labels differ in size");
  const std::uint16_t largest = *std::max_element(labels.begin(), labels.end());
  if (const auto good = check_labels(largest, planes.size()); !good) return good.failure();
  const auto ready = prepare_frame(options_, leaves_, points.count, planes, world_from_sensor);
  if (!ready) return ready.failure();
  PlaneRuns runs(runs_, slots_);
  const PlaneRowCounts counts = register_points(points, labels, *ready, world_from_sensor, runs);
  RegisteredFrame frame = LeafWriter(leaves_, *ready, {world_from_sensor, 0}).put(runs.all());
  frame.off_plane = counts.labelled - counts.near_plane;
  frame.out_of_range = counts.out_of_range;
  return frame;
}

Result<Done> PlaneMapBuilder::merge(const PlaneLeaves& other) {
  if (!leaves_.merge(other)) return refusal("a leaf of the plane map cannot sum more readings");
  return Done{};
}

Result<PlaneMapReading> PlaneMapBuilder::build() const {
  if (const auto good = check_options(options_); !good) return good.failure();
  PlaneMapReading reading;
  const std::vector<PlaneLeaf> leaves = leaves_.sorted();
  reading.report.frames = leaves_.frames;
  reading.report.leaves = leaves.size();
  for (const PlaneLeaf& leaf : leaves) reading.report.readings += leaf.sums.readings;
  // Steps 4 and 5.
  const std::vector<PlanePatch> patches = make_patches(leaves, options_);
  reading.report.patches = static_cast<std::uint32_t>(patches.size());
  const std::vector<PlaneGroup> groups = group_patches(patches, leaves, options_);
  // Steps 6 and 7.
  std::vector<std::vector<std::uint32_t>> group_leaves = leaves_of(groups, patches, leaves.size());
  std::vector<Candidate> candidates;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const PlaneGroup& group = groups[g];
    Candidate c{exported(group, options_), std::move(group_leaves[g])};
    if (*c.plane.points < options_.min_points) {
      ++reading.report.too_few;
    } else if (group.surface.sightings == 0) {
      ++reading.report.fragments;
    } else if (tilt_variance(group.estimate, options_) > options_.max_tilt * options_.max_tilt) {
      ++reading.report.too_vague;
    } else if (is_clutter(group.surface, options_)) {
      ++reading.report.too_rough;
    } else if (options_.polygons && !outline(c, leaves, options_)) {
      ++reading.report.too_small;
    } else {
      candidates.push_back(std::move(c));
    }
  }
  // Step 8.
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return comes_first(a.plane, b.plane); });
  std::vector<std::uint32_t> ids(leaves.size(), 0);
  for (Candidate& c : candidates) {
    c.plane.id = static_cast<std::uint32_t>(reading.map.planes.size() + 1);
    for (const std::uint32_t i : c.leaves) ids[i] = c.plane.id;
    reading.map.planes.push_back(std::move(c.plane));
  }
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (ids[i] != 0) reading.leaf_ids.push_back({leaves[i].key, ids[i]});
  }
  reading.report.planes = static_cast<std::uint32_t>(reading.map.planes.size());
  return reading;
}

std::uint32_t PlaneMapReading::plane_id(const PlaneAnchors& anchors) const {
  std::array<std::uint32_t, 8> ids{};
  std::array<std::uint64_t, 8> votes{};
  for (std::size_t i = 0; i < anchors.leaves.size() && anchors.readings[i] > 0; ++i) {
    const auto found = std::lower_bound(leaf_ids.begin(), leaf_ids.end(), anchors.leaves[i],
                                        [](const LeafId& a, const PlaneLeafKey& key) { return a.key < key; });
    const bool known = found != leaf_ids.end() && found->key == anchors.leaves[i];
    ids[i] = known ? found->id : 0;
    for (std::size_t j = 0; j <= i; ++j) {
      if (ids[j] != ids[i]) continue;
      votes[j] += anchors.readings[i];
      break;
    }
  }
  return ids[static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin())];
}

}  // namespace straightedge
