// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_register.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace straightedge {
namespace {

/// The pose and the camera in one, in quanta of the grid: place = z (u along_u + v along_v + corner) +
/// origin.
struct GridCamera {
  Vector3 along_u, along_v, corner, origin;
};

GridCamera grid_camera(const PinholeCamera& camera, const Pose& pose) {
  const double q = plane_grid::quanta_per_m;
  GridCamera grid;
  grid.along_u = (q / camera.fx) * pose.turned({1, 0, 0});
  grid.along_v = (q / camera.fy) * pose.turned({0, 1, 0});
  grid.corner = q * pose.turned(camera.ray(0, 0));
  grid.origin = q * pose.translation + Vector3{grid_middle, grid_middle, grid_middle};
  return grid;
}

/// A frame's plane in one row: 1/z = by_u · u + constant.
struct RowPlane {
  double by_u = 0, constant = 0;
  double distance = 0;  ///< quanta
};

RowPlane row_plane(const FramePlane& plane, const PinholeCamera& camera, double v) {
  const double by_distance = 1 / std::max(plane.in_camera.distance, 1e-6);
  return {plane.in_camera.normal.x / camera.fx * by_distance,
          dot(plane.in_camera.normal, camera.ray(0, v)) * by_distance,
          plane.in_camera.distance * plane_grid::quanta_per_m};
}

/// Neither a value beyond the bounds nor NaN comes through: that becomes −bound.
double bounded(double x, double bound) {
  const double below = x < bound ? x : bound;
  return below > -bound ? below : -bound;
}

bool on_grid(const GridReading& p) {
  constexpr auto end = static_cast<std::int32_t>(grid_end);
  return p.i >= 0 && p.i < end && p.j >= 0 && p.j < end && p.k >= 0 && p.k < end;
}

/// Some neighbouring pixels with one label. Plain arithmetic first, which compilers turn into vector
/// instructions; decisions after.
struct Segment {
  static constexpr std::int32_t most = 128;
  std::int32_t i[most], j[most], k[most], residual[most];

  /// Steps 1 and 2.
  void place(const std::uint16_t* raw, std::int32_t first, std::int32_t count, double metres_per_unit,
             const RowPlane& plane, const GridCamera& grid, const Vector3& row) noexcept {
    for (std::int32_t n = 0; n < count; ++n) {
      const double u = first + n;
      const double inverse = plane.by_u * u + plane.constant;
      const double z = 1 / inverse;
      i[n] = static_cast<std::int32_t>(bounded(z * (u * grid.along_u.x + row.x) + grid.origin.x, grid_end));
      j[n] = static_cast<std::int32_t>(bounded(z * (u * grid.along_u.y + row.y) + grid.origin.y, grid_end));
      k[n] = static_cast<std::int32_t>(bounded(z * (u * grid.along_u.z + row.z) + grid.origin.z, grid_end));
      const double beyond = raw[n] * metres_per_unit * inverse - 1;
      residual[n] = static_cast<std::int32_t>(bounded(beyond * plane.distance, most_residual));
    }
  }
  GridReading at(std::int32_t n) const noexcept { return {i[n], j[n], k[n], residual[n]}; }
};

/// Runs that may go on: the next row of the picture mostly falls into the same leaves as the one before. Each
/// has one place; a run that is in the way of another goes to its leaf.
class OpenRuns {
 public:
  explicit OpenRuns(LeafWriter& writer) : writer_(writer), runs_(places) {}

  /// The run to which the reading goes, a new one if need be.
  LeafRun& of(std::uint32_t label, const GridReading& p) {
    const MortonCell leaf = p.leaf();
    const std::uint32_t mixed = leaf.x * 73 + leaf.y * 179 + leaf.z * 283 + label * 97;
    LeafRun& run = runs_[mixed % places];
    if (run.label == label && run.first.same_leaf(p) && run.readings < LeafRun::most_readings) return run;
    writer_.put(run);
    run = {};
    run.label = label;
    run.first = p;
    return run;
  }
  void put_all() {
    for (const LeafRun& run : runs_) writer_.put(run);
  }

 private:
  static constexpr std::uint32_t places = 256;

  LeafWriter& writer_;
  std::vector<LeafRun> runs_;
};

inline void add_reading(LeafRun& run, const GridReading& p) {
  constexpr std::int32_t within = plane_grid::leaf_side - 1;
  constexpr std::int32_t half = plane_grid::leaf_side / 2;
  const std::int32_t x = (p.i & within) - half;
  const std::int32_t y = (p.j & within) - half;
  const std::int32_t z = (p.k & within) - half;
  run.readings += 1;
  run.x += x;
  run.y += y;
  run.z += z;
  run.xx += x * x;
  run.xy += x * y;
  run.xz += x * z;
  run.yy += y * y;
  run.yz += y * z;
  run.zz += z * z;
  run.residual += std::int64_t{p.residual} * p.residual;
}

/// Adds readings from n on while they fall into the run's leaf; returns the first that does not.
std::int32_t add_neighbours(LeafRun& run, const Segment& segment, std::int32_t n, std::int32_t end,
                            std::int32_t far_off) {
  LeafRun sums = run;  // a copy of its own stays in registers
  end = std::min(end, n + (LeafRun::most_readings - sums.readings));
  for (; n < end; ++n) {
    const GridReading p = segment.at(n);
    if (!sums.first.same_leaf(p) || p.residual > far_off || p.residual < -far_off) break;
    add_reading(sums, p);
  }
  run = sums;
  return n;
}

}  // namespace

LeftOut register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                       std::span<const FramePlane> planes, const Pose& world_from_camera,
                       LeafWriter& writer) {
  LeftOut out;
  const GridCamera grid = grid_camera(depth.camera, world_from_camera);
  Segment segment;
  OpenRuns runs(writer);
  for (std::int32_t y = 0; y < depth.raw.height; ++y) {
    const std::uint16_t* raw = depth.raw.row(y);
    const std::uint16_t* label = labels.row(y);
    const Vector3 row = static_cast<double>(y) * grid.along_v + grid.corner;
    for (std::int32_t x = 0; x < labels.width;) {
      const std::int32_t first = x;
      while (x < labels.width && label[x] == label[first] && x - first < Segment::most) ++x;
      if (label[first] == 0) continue;
      // Steps 1 and 2.
      const FramePlane& plane = planes[label[first] - 1U];
      const RowPlane in_row = row_plane(plane, depth.camera, y);
      const std::int32_t count = x - first;
      segment.place(raw + first, first, count, depth.metres_per_unit, in_row, grid, row);
      // Step 3.
      const double half = std::min(0.5 * in_row.distance, most_residual - 1.0);
      const auto far_off = static_cast<std::int32_t>(half);
      for (std::int32_t n = 0; n < count;) {
        const GridReading p = segment.at(n);
        if (p.residual > far_off || p.residual < -far_off) {
          out.off_plane += raw[first + n++] != 0 ? 1 : 0;
          continue;
        }
        if (!on_grid(p)) {
          ++out.out_of_range;
          ++n;
          continue;
        }
        n = add_neighbours(runs.of(label[first], p), segment, n, count, far_off);
      }
    }
  }
  runs.put_all();
  return out;
}

LeftOut register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                        std::span<const FramePlane> planes, const Pose& world_from_sensor,
                        LeafWriter& writer) {
  LeftOut out;
  OpenRuns runs(writer);
  for (std::size_t n = 0; n < points.count; ++n) {
    const std::uint16_t label = labels[n];
    const Vector3 reading = points.at(n);
    if (label == 0 || !finite(reading)) continue;
    // Step 1. Where noise runs along the ray, back along it; else straight.
    const FramePlane& plane = planes[label - 1U];
    const double beyond = plane.in_camera.signed_distance(reading);
    const bool along_ray = plane.weight_by_depth > 0;
    const double distance = plane.in_camera.distance;
    const double reach = along_ray ? 0.5 * distance : 0.5 * length(reading);
    if ((along_ray && !(reading.z > 0)) || !(beyond >= -reach && beyond <= reach)) {
      ++out.off_plane;
      continue;
    }
    const Vector3 on_plane =
        along_ray ? (distance / (distance + beyond)) * reading : reading - beyond * plane.in_camera.normal;
    // Step 2.
    const Vector3 place = plane_grid::quanta_per_m * world_from_sensor.apply(on_plane) +
                          Vector3{grid_middle, grid_middle, grid_middle};
    const GridReading p{static_cast<std::int32_t>(bounded(place.x, grid_end)),
                        static_cast<std::int32_t>(bounded(place.y, grid_end)),
                        static_cast<std::int32_t>(bounded(place.z, grid_end)),
                        static_cast<std::int32_t>(bounded(beyond * plane_grid::quanta_per_m, most_residual))};
    if (!on_grid(p)) {
      ++out.out_of_range;
      continue;
    }
    // Step 3.
    add_reading(runs.of(label, p), p);
  }
  runs.put_all();
  return out;
}

}  // namespace straightedge
