// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/measure_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "map/median.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/plane_fit.hpp"

namespace straightedge {
namespace {

constexpr std::size_t samples = 1000;
constexpr std::size_t neighbours = 24;
constexpr double smallest_leaf_m = 1e-6;
constexpr std::size_t most_points = std::size_t{1} << 30U;

Failure refusal(Status status) {
  return {Problem::bad_content, to_string(status)};
}

/// Sums for a straight line through (at, value).
struct LineSums {
  double n = 0, a = 0, v = 0, aa = 0, av = 0, vv = 0;

  void add(double at, double value) {
    n += 1;
    a += at;
    v += value;
    aa += at * at;
    av += at * value;
    vv += value * value;
  }
  /// The line rises, and the values lie within one step of it.
  bool straight() const {
    const double scatter = aa - a * a / n, slope = (av - a * v / n) / scatter;
    const double residual = (vv - v * v / n) - slope * slope * scatter;
    return scatter > 0 && residual < slope * slope * n;
  }
};

/// Step 5.
bool is_picture(const PointsView& points) {
  if (points.width < 2 || points.count <= static_cast<std::size_t>(points.width)) return false;
  const auto width = static_cast<std::size_t>(points.width);
  LineSums columns, rows;
  for (std::size_t i = 0; i < points.count; ++i) {
    const Vector3 at = points.at(i);
    if (!finite(at)) continue;
    if (!(at.z > 0)) return false;
    columns.add(static_cast<double>(i % width), at.x / at.z);
    rows.add(static_cast<double>(i / width), at.y / at.z);
  }
  return columns.n > 2 && columns.straight() && rows.straight();
}

/// Step 1.
std::vector<std::size_t> sample(const PointsView& points) {
  std::vector<std::size_t> readings;
  for (std::size_t i = 0; i < points.count; ++i) {
    if (finite(points.at(i))) readings.push_back(i);
  }
  const std::size_t step = (readings.size() + samples - 1) / samples;
  std::vector<std::size_t> kept;
  for (std::size_t i = step / 2; i < readings.size(); i += step) kept.push_back(readings[i]);
  return readings.size() > neighbours ? kept : std::vector<std::size_t>{};
}

/// Leaves of a few points each, if the points cover a surface as wide as their box.
Result<OctreeGrid> grid_for(const PointsView& points) {
  const OctreeFit first = fit_octree_grid(points, smallest_leaf_m);
  if (first.status != Status::ok) return refusal(first.status);
  const double width = length(first.box.max - first.box.min);
  const double leaf = 2 * width / std::sqrt(static_cast<double>(first.points));
  const OctreeFit fit = fit_octree_grid(points, std::max(leaf, smallest_leaf_m));
  if (fit.status != Status::ok) return refusal(fit.status);
  return fit.grid;
}

}  // namespace

Result<CloudScale> measure_cloud(const PointsView& points) {
  if (!points.valid()) return refusal(Status::invalid_image);
  if (points.count > most_points) return refusal(Status::too_large);
  const std::vector<std::size_t> places = sample(points);
  if (places.empty()) return CloudScale{};
  // Step 2.
  const auto grid = grid_for(points);
  if (!grid) return grid.failure();
  const OctreeOptions options{.grid = *grid};
  const auto capacity = static_cast<std::uint32_t>(points.count);
  const std::size_t bytes = Octree::workspace_bytes(capacity, options);
  const auto memory = std::make_unique_for_overwrite<std::byte[]>(bytes);
  Octree octree;
  if (const Status status = Octree::prepare(octree, capacity, options, {memory.get(), bytes});
      status != Status::ok)
    return refusal(status);
  if (const auto built = octree.build(points); built.status != Status::ok) return refusal(built.status);
  std::vector<double> residuals, radii;
  for (const std::size_t place : places) {
    const Vector3 centre = points.at(place);
    std::array<OctreeNeighbour, neighbours> near;
    const OctreeFound found = octree.k_nearest(centre, near);
    if (found.status != Status::ok || found.found < neighbours) continue;
    PlaneMoments moments;
    for (const OctreeNeighbour& one : near) moments.add(points.at(one.index) - centre);
    PlaneFit plane;
    if (fit_plane(moments, plane) != Status::ok) continue;
    // Steps 3 and 4.
    residuals.push_back(plane.rms * std::sqrt(neighbours / (neighbours - 3.0)));
    radii.push_back(std::sqrt(near.back().squared_distance));
  }
  return CloudScale{median(residuals), median(radii) * std::sqrt(3.141592653589793 / neighbours),
                    is_picture(points)};
}

}  // namespace straightedge
