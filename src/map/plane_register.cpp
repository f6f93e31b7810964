// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_register.hpp"

#include <algorithm>
#include <vector>

#include "map/plane_piece.hpp"
#include "map/plane_place.hpp"
#include "map/plane_run_search.hpp"

namespace straightedge {

static_assert(plane_row::leaf_bits == plane_grid::leaf_bits && plane_row::grid_end == grid_end);

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

void set(double (&to)[3], const Vector3& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

std::vector<PixelPlane> pixel_planes(std::span<const FramePlane> planes, const PinholeCamera& camera) {
  std::vector<PixelPlane> all;
  all.reserve(planes.size());
  for (const FramePlane& plane : planes) {
    PixelPlane p;
    set(p.normal, plane.in_camera.normal);
    p.by_distance = 1 / std::max(plane.in_camera.distance, 1e-6);
    p.by_u = plane.in_camera.normal.x / camera.fx * p.by_distance;
    p.distance = plane.in_camera.distance * plane_grid::quanta_per_m;
    p.far_off = static_cast<std::int32_t>(std::min(0.5 * p.distance, plane_row::most_residual - 1.0));
    all.push_back(p);
  }
  return all;
}

/// What all parts of rows have in common.
PlaneRowPart part_of(const DepthView& depth, const GridCamera& grid) {
  PlaneRowPart part;
  part.metres_per_unit = depth.metres_per_unit;
  set(part.along_u, grid.along_u);
  set(part.origin, grid.origin);
  return part;
}

std::int32_t quanta(double x) {
  return static_cast<std::int32_t>(plain::bounded(x, grid_end));
}

bool on_grid(std::int32_t quanta) {
  return quanta >= 0 && quanta < plane_row::grid_end;
}

}  // namespace

LeftOut register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                       std::span<const FramePlane> planes, const Pose& world_from_camera, PlaneRuns& runs,
                       const PlaneRowKernels& kernels) {
  LeftOut out;
  const GridCamera grid = grid_camera(depth.camera, world_from_camera);
  const std::vector<PixelPlane> by_pixels = pixel_planes(planes, depth.camera);
  PlaneRowPart part = part_of(depth, grid);
  part.planes = by_pixels.data();
  PlaneRowPlaces places;
  for (std::int32_t y = 0; y < depth.raw.height; ++y) {
    set(part.ray, depth.camera.ray(0, y));
    set(part.row, static_cast<double>(y) * grid.along_v + grid.corner);
    for (std::int32_t x = 0; x < labels.width; x += PlaneRowPart::most) {
      part.raw = depth.raw.row(y) + x;
      part.labels = labels.row(y) + x;
      part.first = x;
      part.to_row_end = labels.width - x;
      part.count = std::min(part.to_row_end, PlaneRowPart::most);
      kernels.add(part, places, runs.with_room_for(PlaneRowPart::most), out);
    }
  }
  return out;
}

LeftOut register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                        std::span<const FramePlane> planes, const Pose& world_from_sensor, PlaneRuns& runs) {
  LeftOut out;
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
    const std::int32_t i = quanta(place.x), j = quanta(place.y), k = quanta(place.z);
    if (!on_grid(i) || !on_grid(j) || !on_grid(k)) {
      ++out.out_of_range;
      continue;
    }
    // Step 3.
    detail::PlaneRun& run = plain::run_for(runs.with_room_for(1), plain::run_leaf(i, j, k), label, 1);
    const double residual = plain::bounded(beyond * plane_grid::quanta_per_m, plane_row::most_residual);
    plain::add_reading(run, i, j, k, static_cast<std::int32_t>(residual));
  }
  return out;
}

}  // namespace straightedge
