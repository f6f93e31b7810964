// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_frame.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "straightedge/morton.hpp"
#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

// Pieces of one wall that a detector took for two planes are one sighting of it.
constexpr double same_cosine = 0.9986;  // 3 degrees
constexpr double same_offset = 0.02;    // metres

bool same_in_frame(const FoundPlane& a, const FoundPlane& b) {
  return dot(a.fit.plane.normal, b.fit.plane.normal) > same_cosine &&
         std::abs(a.fit.plane.signed_distance(b.fit.centroid)) < same_offset;
}

bool is_plane(const Plane& plane) {
  const double size = squared_length(plane.normal);
  return size > 1 - 1e-6 && size < 1 + 1e-6 && plane.distance >= 0 && plane.distance < plane_grid::reach_m;
}

std::int64_t tilt_of(const PlaneFit& fit) {
  const double variance = std::max(fit.covariance[0], fit.covariance[3]) / plane_grid::tilt_unit;
  if (!(variance > 0)) return 0;
  return variance < static_cast<double>(plane_grid::most_tilt) ? round_half_even(variance)
                                                               : plane_grid::most_tilt;
}

void set_weight(FramePlane& plane, const PlaneGate& gate) {
  if (gate.fixed_m > 0) {
    const double sigma = gate.fixed_m / gate.sigmas;
    plane.weight_anywhere = 1 / (sigma * sigma * plane_grid::weight_unit);
    return;
  }
  // Noise runs along the ray: across the plane it is sigma_z |n·r| / |r_z| = inverse_sigma · z · distance.
  const double across = gate.inverse_sigma * std::max(plane.in_camera.distance, 1e-3);
  plane.weight_by_depth = 1 / (across * across * plane_grid::weight_unit);
}

/// Of every reading of the plane in a leaf whose centre has this depth: so it does not matter which reading
/// of the leaf comes first.
std::int64_t weight_at(double z, const FramePlane& plane) {
  constexpr auto most = static_cast<double>(plane_grid::most_weight);
  const double weight = plane.weight_by_depth / (z * z) + plane.weight_anywhere;
  return static_cast<std::int64_t>(std::clamp(weight + 0.5, 1.0, most));
}

/// Quanta between neighbouring pixels: along a plane's steepest direction they are z/distance times farther
/// apart than across.
std::uint16_t spacing_at(double z, const FramePlane& plane, double focal) {
  if (!(focal > 0)) return plane_grid::no_spacing;
  const double across = z / focal * plane_grid::quanta_per_m;
  const double quanta = across * std::max(1.0, z / std::max(plane.in_camera.distance, 1e-3));
  return quanta < plane_grid::no_spacing ? static_cast<std::uint16_t>(quanta) : plane_grid::no_spacing;
}

/// The run's sums as its leaf adds them.
PlaneLeafSums weighted(const detail::PlaneRun& run, const FramePlane& plane, std::int64_t w) {
  using Run = detail::PlaneRun;
  PlaneLeafSums s;
  s.readings = static_cast<std::uint64_t>(run.readings);
  s.weight = w * run.readings;
  s.x = w * run.sum[Run::x];
  s.y = w * run.sum[Run::y];
  s.z = w * run.z;
  s.xx = w * run.sum[Run::xx];
  s.xy = w * run.sum[Run::xy];
  s.xz = w * run.sum[Run::xz];
  s.yy = w * run.sum[Run::yy];
  s.yz = w * run.sum[Run::yz];
  s.zz = w * run.sum[Run::zz];
  s.nx = s.weight * plane.normal.x;
  s.ny = s.weight * plane.normal.y;
  s.nz = s.weight * plane.normal.z;
  s.tilt = s.weight * plane.tilt;
  // Wrong labels miss their plane by metres; what they add stays within the bound of all sums.
  const bool near = run.residual >> 14U < run.readings;  // as the weight is at most 2^16: no need to divide
  s.residual = w * (near ? run.residual : std::min(run.residual, (std::int64_t{run.readings} << 30U) / w));
  return s;
}

MortonCell cell_of(std::uint64_t leaf) {
  constexpr std::uint64_t axis = morton_side - 1;
  return {static_cast<std::uint32_t>(leaf & axis), static_cast<std::uint32_t>((leaf >> 21U) & axis),
          static_cast<std::uint32_t>(leaf >> 42U)};
}

void note(PlaneAnchors& anchors, PlaneLeafKey key, std::uint32_t readings) {
  if (readings < anchors.readings.back()) return;
  for (std::size_t i = 0; i < anchors.leaves.size(); ++i) {
    const bool before =
        readings > anchors.readings[i] || (readings == anchors.readings[i] && key < anchors.leaves[i]);
    if (!before) continue;
    std::swap(key, anchors.leaves[i]);
    std::swap(readings, anchors.readings[i]);
  }
}

}  // namespace

Result<Done> check_pose(const Pose& pose) {
  const auto& r = pose.rotation;
  const Vector3 row0{r[0], r[1], r[2]};
  const Vector3 row1{r[3], r[4], r[5]};
  const Vector3 row2{r[6], r[7], r[8]};
  const auto unit = [](const Vector3& v) { return std::abs(squared_length(v) - 1) < 1e-4; };
  const auto square = [](const Vector3& a, const Vector3& b) { return std::abs(dot(a, b)) < 1e-4; };
  if (!finite(pose.translation) || !unit(row0) || !unit(row1) || !unit(row2) || !square(row0, row1) ||
      !square(row0, row2) || !square(row1, row2) || !(dot(cross(row0, row1), row2) > 0))
    return Failure{Problem::bad_content, "the frame's pose is no rotation with a translation"};
  const Vector3& t = pose.translation;
  const double farthest = std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)});
  if (!(farthest < plane_grid::reach_m))
    return Failure{Problem::bad_content, "the frame's pose lies more than 131 km from the world's origin"};
  return Done{};
}

Result<std::vector<FramePlane>> frame_planes(std::span<const FoundPlane> planes, const Pose& pose,
                                             const PlaneGate& gate) {
  std::vector<FramePlane> ready;
  ready.reserve(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    FramePlane plane;
    plane.in_camera = planes[i].fit.plane;
    if (!is_plane(plane.in_camera) || !finite(planes[i].fit.centroid))
      return Failure{Problem::bad_content, "plane " + std::to_string(i + 1) + " of the frame is no plane"};
    const Vector3 foot = pose.apply(plane.in_camera.distance * plane.in_camera.normal);
    plane.towards_camera = normalized(-pose.turned(plane.in_camera.normal));
    plane.offset = dot(plane.towards_camera, foot);
    plane.normal = grid_normal(plane.towards_camera);
    plane.direction = direction_bin(plane.normal);
    plane.tilt = tilt_of(planes[i].fit);
    set_weight(plane, gate);
    for (std::size_t j = 0; j < i && plane.counts; ++j) plane.counts = !same_in_frame(planes[j], planes[i]);
    ready.push_back(plane);
  }
  return ready;
}

LeafWriter::Target LeafWriter::target_of(const detail::PlaneRun& run) const {
  const FramePlane& plane = planes_[run.label - 1];
  Target target;
  const MortonCell cell = cell_of(run.leaf);
  const Vector3 centre = leaf_centre(cell);
  const double depth = dot(forward_, centre - view_.world_from_camera.translation);
  target.depth = std::max(depth, plane_grid::leaf_m);
  const double offset = plane.offset - dot(plane.towards_camera, centre);
  target.key = {morton_encode(cell), surface_bin(plane.direction, offset * plane_grid::quanta_per_m)};
  return target;
}

void LeafWriter::put(const detail::PlaneRun& run, const Target& target) {
  const FramePlane& plane = planes_[run.label - 1];
  PlaneLeafSums s = weighted(run, plane, weight_at(target.depth, plane));
  s.spacing = spacing_at(target.depth, plane, view_.focal);
  leaves_.add(target.key, s);
}

RegisteredFrame LeafWriter::put(std::span<const detail::PlaneRun> runs) {
  // A few runs at a time, so that the memory of all their leaves is on its way before the first is needed.
  constexpr std::size_t at_once = 64;
  RegisteredFrame frame;
  frame.planes.resize(planes_.size());
  std::array<Target, at_once> targets;
  for (std::size_t first = 0; first < runs.size(); first += at_once) {
    const std::span<const detail::PlaneRun> some =
        runs.subspan(first, std::min(at_once, runs.size() - first));
    for (std::size_t i = 0; i < some.size(); ++i) {
      targets[i] = target_of(some[i]);
      leaves_.expect(targets[i].key);
    }
    for (std::size_t i = 0; i < some.size(); ++i) leaves_.expect_sums(targets[i].key);
    for (std::size_t i = 0; i < some.size(); ++i) {
      put(some[i], targets[i]);
      const auto readings = static_cast<std::uint32_t>(some[i].readings);
      frame.placed += readings;
      note(frame.planes[some[i].label - 1], targets[i].key, readings);
    }
  }
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    if (planes_[p].counts && frame.planes[p].readings[0] > 0)
      ++leaves_.at(leaves_.place(frame.planes[p].leaves[0])).sightings;
  }
  ++leaves_.frames;
  return frame;
}

}  // namespace straightedge
