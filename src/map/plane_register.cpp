// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_register.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "map/plane_bundle.hpp"
#include "map/plane_run_search.hpp"

namespace straightedge {

static_assert(plane_row::leaf_bits == plane_grid::leaf_bits && plane_row::grid_end == grid_end);

namespace {

void set(double (&to)[3], const Vector3& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

/// The pose and the camera in one.
GridCamera grid_camera(const PinholeCamera& camera, const Pose& pose) {
  const double q = plane_grid::quanta_per_m;
  GridCamera grid;
  set(grid.along_u, (q / camera.fx) * pose.turned({1, 0, 0}));
  set(grid.along_v, (q / camera.fy) * pose.turned({0, 1, 0}));
  set(grid.corner, q * pose.turned(camera.ray(0, 0)));
  set(grid.origin, q * pose.translation + Vector3{grid_middle, grid_middle, grid_middle});
  return grid;
}

std::vector<PixelPlane> pixel_planes(std::span<const FramePlane> planes, const PinholeCamera& camera) {
  std::vector<PixelPlane> all;
  all.reserve(planes.size());
  for (const FramePlane& plane : planes) {
    const double by_distance = 1 / std::max(plane.in_camera.distance, 1e-6);
    PixelPlane p;
    p.by_u = plane.in_camera.normal.x / camera.fx * by_distance;
    p.by_v = plane.in_camera.normal.y / camera.fy * by_distance;
    p.constant = dot(plane.in_camera.normal, camera.ray(0, 0)) * by_distance;
    p.distance = plane.in_camera.distance * plane_grid::quanta_per_m;
    p.far_off = static_cast<std::int32_t>(std::min(0.5 * p.distance, plane_row::most_residual - 1.0));
    all.push_back(p);
  }
  return all;
}

/// Where a picture's end cuts a row of squares: a copy with all of its pixels.
struct RowCopy {
  std::uint16_t raw[PlaneRow::side][PlaneRow::most_columns] = {};
  std::uint16_t labels[PlaneRow::side][PlaneRow::most_columns] = {};
};

/// Shows the row the pixels from (row.u, row.v) on.
void show(const DepthView& depth, ImageView<const std::uint16_t> labels, RowCopy& copy, PlaneRow& row) {
  const std::int32_t wide = std::min(labels.width - row.u, PlaneRow::most_columns);
  row.columns = (wide + PlaneRow::at_once - 1) / PlaneRow::at_once * PlaneRow::at_once;
  for (std::int32_t y = 0; y < PlaneRow::side; ++y) {
    const bool inside = row.v + y < labels.height;
    if (inside && wide == row.columns) {
      const std::int32_t below = row.v + y + PlaneRow::side;
      const std::int32_t next = below < labels.height ? below : row.v + y;
      row.raw[y] = depth.raw.row(row.v + y) + row.u;
      row.labels[y] = labels.row(row.v + y) + row.u;
      row.next[y] = depth.raw.row(next) + row.u;
      row.next[PlaneRow::side + y] = labels.row(next) + row.u;
      continue;
    }
    if (inside) {
      std::copy_n(depth.raw.row(row.v + y) + row.u, wide, copy.raw[y]);
      std::copy_n(labels.row(row.v + y) + row.u, wide, copy.labels[y]);
    }
    std::fill(copy.labels[y] + (inside ? wide : 0), std::end(copy.labels[y]), std::uint16_t{0});
    row.raw[y] = row.next[y] = copy.raw[y];
    row.labels[y] = row.next[PlaneRow::side + y] = copy.labels[y];
  }
}

std::int32_t quanta(double x) {
  return static_cast<std::int32_t>(plain::bounded(x, grid_end));
}

bool on_grid(std::int32_t quanta) {
  return quanta >= 0 && quanta < plane_row::grid_end;
}

}  // namespace

PlaneRowCounts register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                              std::span<const FramePlane> planes, const Pose& world_from_camera,
                              PlaneRuns& runs, const PlaneRowKernels& kernels) {
  PlaneRowCounts counts;
  const std::vector<PixelPlane> by_pixels = pixel_planes(planes, depth.camera);
  RowCopy copy;
  PlaneColumns columns;
  PlaneRow row;
  row.metres_per_unit = depth.metres_per_unit;
  row.grid = grid_camera(depth.camera, world_from_camera);
  row.planes = by_pixels.data();
  row.plane_count = static_cast<std::uint32_t>(by_pixels.size());
  for (row.v = 0; row.v < labels.height; row.v += PlaneRow::side) {
    for (row.u = 0; row.u < labels.width; row.u += PlaneRow::most_columns) {
      show(depth, labels, copy, row);
      kernels.add(row, columns, runs.with_room_for(PlaneRow::most_runs), counts);
    }
  }
  return counts;
}

PlaneRowCounts register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                               std::span<const FramePlane> planes, const Pose& world_from_sensor,
                               PlaneRuns& runs) {
  PlaneRowCounts counts;
  for (std::size_t n = 0; n < points.count; ++n) {
    const std::uint16_t label = labels[n];
    const Vector3 reading = points.at(n);
    if (label == 0 || !finite(reading)) continue;
    ++counts.labelled;
    // Step 1. Where noise runs along the ray, back along it; else straight.
    const FramePlane& plane = planes[label - 1U];
    const double beyond = plane.in_camera.signed_distance(reading);
    const bool along_ray = plane.weight_by_depth > 0;
    const double distance = plane.in_camera.distance;
    const double reach = along_ray ? 0.5 * distance : 0.5 * length(reading);
    if ((along_ray && !(reading.z > 0)) || !(beyond >= -reach && beyond <= reach)) {
      continue;
    }
    ++counts.near_plane;
    const Vector3 on_plane =
        along_ray ? (distance / (distance + beyond)) * reading : reading - beyond * plane.in_camera.normal;
    // Step 2.
    const Vector3 place = plane_grid::quanta_per_m * world_from_sensor.apply(on_plane) +
                          Vector3{grid_middle, grid_middle, grid_middle};
    const std::int32_t i = quanta(place.x), j = quanta(place.y), k = quanta(place.z);
    if (!on_grid(i) || !on_grid(j) || !on_grid(k)) {
      ++counts.out_of_range;
      continue;
    }
    // Step 3.
    detail::PlaneRun& run = plain::run_for(runs.with_room_for(1), plain::run_leaf(i, j, k), label, 1);
    const double residual = plain::bounded(beyond * plane_grid::quanta_per_m, plane_row::most_residual);
    plain::BundleSums bundle;
    bundle.add(plain::BundlePlace{i, j, k, plain::BundleSums::one}, 1,
               static_cast<std::int64_t>(residual * residual));
    bundle.add_to(run);
  }
  return counts;
}

}  // namespace straightedge
