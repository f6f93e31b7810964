// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_register.hpp"

#include <algorithm>
#include <vector>

#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

/// A plane's readings lie where 1/z = a u + b v + c; nothing else is needed of it pixel by pixel.
struct RowPlane {
  double a = 0, row = 0;  ///< 1/z = a u + row
  double distance = 0;
  double weight_by_depth = 0, weight_anywhere = 0;
};

/// The pose and the camera in one, in quanta of the grid: place = z (u along_u + row) + origin.
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

std::int64_t weight_of(double weight) {
  constexpr auto most = static_cast<double>(plane_grid::most_weight);
  return static_cast<std::int64_t>(std::clamp(weight + 0.5, 1.0, most));
}

std::int64_t residual_of(double metres) {
  constexpr double most = 1 << 20U;
  return static_cast<std::int64_t>(std::clamp(metres * plane_grid::quanta_per_m, -most, most));
}

bool on_grid(const Vector3& p) {
  return p.x >= 0 && p.x < grid_end && p.y >= 0 && p.y < grid_end && p.z >= 0 && p.z < grid_end;
}

struct GridPoint {
  std::int32_t i = 0, j = 0, k = 0;

  explicit GridPoint(const Vector3& p)
      : i(static_cast<std::int32_t>(p.x)), j(static_cast<std::int32_t>(p.y)), k(static_cast<std::int32_t>(p.z)) {}
  LeafPlace leaf() const {
    constexpr int bits = plane_grid::leaf_bits;
    return {static_cast<std::uint32_t>(i >> bits), static_cast<std::uint32_t>(j >> bits),
            static_cast<std::uint32_t>(k >> bits)};
  }
};

/// Metres from a pixel to the next on a plane at this depth, along its steepest direction.
double pixel_spacing(double z, double distance, double focal) {
  return z / focal * std::max(1.0, z / std::max(distance, 1e-3));
}

void start_row(std::span<const FramePlane> planes, const PinholeCamera& camera, double v,
               std::vector<RowPlane>& rows) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i].in_camera;
    const double by_distance = 1 / std::max(plane.distance, 1e-6);
    const Vector3 ray = camera.ray(0, v);
    rows[i] = {plane.normal.x / camera.fx * by_distance, dot(plane.normal, ray) * by_distance,
               plane.distance, planes[i].weight_by_depth, planes[i].weight_anywhere};
  }
}

}  // namespace

LeftOut register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                       std::span<const FramePlane> planes, const Pose& world_from_camera,
                       LeafWriter& writer) {
  LeftOut out;
  const GridCamera grid = grid_camera(depth.camera, world_from_camera);
  const double focal = std::min(std::abs(depth.camera.fx), std::abs(depth.camera.fy));
  std::vector<RowPlane> rows(planes.size());
  LeafRun run;
  double z = 0;
  const auto put = [&] { writer.put(run, pixel_spacing(z, planes[run.label - 1].in_camera.distance, focal)); };
  for (std::int32_t y = 0; y < depth.raw.height; ++y) {
    const std::uint16_t* raw = depth.raw.row(y);
    const std::uint16_t* label = labels.row(y);
    start_row(planes, depth.camera, y, rows);
    const Vector3 row = static_cast<double>(y) * grid.along_v + grid.corner;
    for (std::int32_t x = 0; x < depth.raw.width; ++x) {
      if (label[x] == 0 || raw[x] == 0) continue;
      // Step 1. By how much of its depth the reading lies before or behind the plane.
      const RowPlane& plane = rows[label[x] - 1U];
      const double u = x;
      const double inverse = plane.a * u + plane.row;
      const double beyond = raw[x] * depth.metres_per_unit * inverse - 1;
      if (!(beyond > -0.5 && beyond < 0.5)) {
        ++out.off_plane;
        continue;
      }
      // Step 2.
      const double on_plane = 1 / inverse;
      const Vector3 place = on_plane * (u * grid.along_u + row) + grid.origin;
      if (!on_grid(place)) {
        ++out.out_of_range;
        continue;
      }
      // Step 3.
      const GridPoint p(place);
      const LeafPlace leaf = p.leaf();
      if (run.label != label[x] || run.place != leaf) {
        if (run.label != 0) put();
        run.label = label[x];
        run.place = leaf;
      }
      z = on_plane;
      run.add(p.i, p.j, p.k, weight_of(plane.weight_by_depth * inverse * inverse + plane.weight_anywhere),
              residual_of(beyond * plane.distance));
    }
  }
  if (run.label != 0) put();
  return out;
}

LeftOut register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                        std::span<const FramePlane> planes, const Pose& world_from_sensor,
                        LeafWriter& writer) {
  LeftOut out;
  LeafRun run;
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
    const Vector3 on_plane = along_ray ? (distance / (distance + beyond)) * reading
                                       : reading - beyond * plane.in_camera.normal;
    // Step 2.
    const Vector3 in_world = world_from_sensor.apply(on_plane);
    const Vector3 place =
        plane_grid::quanta_per_m * in_world + Vector3{grid_middle, grid_middle, grid_middle};
    if (!on_grid(place)) {
      ++out.out_of_range;
      continue;
    }
    // Step 3.
    const GridPoint p(place);
    if (run.label != label || run.place != p.leaf()) {
      writer.put(run, 0);
      run.label = label;
      run.place = p.leaf();
    }
    const double by_depth = along_ray ? plane.weight_by_depth / (on_plane.z * on_plane.z) : 0;
    run.add(p.i, p.j, p.k, weight_of(by_depth + plane.weight_anywhere), residual_of(beyond));
  }
  writer.put(run, 0);
  return out;
}

}  // namespace straightedge
