// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_copies.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "map/plane_outline.hpp"
#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

constexpr double greater_part = 0.5;

using Cell = std::pair<std::int64_t, std::int64_t>;

/// The cells, of a leaf's size, on the plane in which the group has leaves that are near it.
std::vector<Cell> cells_of(const PlaneGroup& group, const PlaneChart& chart, const Plane& plane,
                           double max_offset, std::span<const PlanePatch> patches,
                           std::span<const PlaneLeaf> leaves) {
  std::vector<Cell> cells;
  for (const std::uint32_t p : group.patches) {
    for (const std::uint32_t i : patches[p].leaves) {
      const Surface s = surface_of(leaves[i], patches[p].surface.origin);
      const Vector3 mean = s.origin + (1 / s.moments.weight) * Vector3{s.moments.x, s.moments.y, s.moments.z};
      const double offset = plane.signed_distance(mean);
      if (offset > max_offset || offset < -max_offset) continue;
      const PlanePoint at = chart.on(mean);
      cells.push_back(
          {floor_to_integer(at.a / plane_grid::leaf_m), floor_to_integer(at.b / plane_grid::leaf_m)});
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

std::size_t leaf_count(const PlaneGroup& group, std::span<const PlanePatch> patches) {
  std::size_t count = 0;
  for (const std::uint32_t p : group.patches) count += patches[p].leaves.size();
  return count;
}

bool may_be_copy(const PlaneGroup& heavy, const PlaneGroup& light, const PlaneMapOptions& options) {
  const SurfaceEstimate& h = heavy.estimate;
  const SurfaceEstimate& l = light.estimate;
  const double facing = dot(h.normal, l.normal);
  const double offset = dot(h.normal, l.centroid - h.centroid);
  return 1 - facing * facing <= options.copy_angle * options.copy_angle && offset <= options.copy_offset &&
         offset >= -options.copy_offset;
}

/// Whether the greater part of both was seen from one and the same side.
bool same_side(const PlaneGroup& a, const PlaneGroup& b) {
  const bool facing = dot(a.surface.towards_camera, b.surface.towards_camera) > 0;
  const bool a_front = a.surface.seen_front >= a.surface.seen_back;
  const bool b_front = b.surface.seen_front >= b.surface.seen_back;
  return facing == (a_front == b_front);
}

bool is_copy(const PlaneGroup& heavy, const PlaneGroup& light, std::span<const PlanePatch> patches,
             std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options) {
  const Plane plane{heavy.estimate.normal, dot(heavy.estimate.normal, heavy.estimate.centroid)};
  const PlaneChart chart(plane, heavy.estimate.centroid);
  const std::vector<Cell> over = cells_of(light, chart, plane, options.copy_offset, patches, leaves);
  if (static_cast<double>(over.size()) < greater_part * static_cast<double>(leaf_count(light, patches)) / 2)
    return false;
  const std::vector<Cell> under = cells_of(heavy, chart, plane, options.copy_offset, patches, leaves);
  std::vector<Cell> common;
  std::set_intersection(over.begin(), over.end(), under.begin(), under.end(), std::back_inserter(common));
  return static_cast<double>(common.size()) > greater_part * static_cast<double>(over.size());
}

}  // namespace

bool join_copies(std::vector<PlaneGroup>& groups, std::span<const PlanePatch> patches,
                 std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options) {
  bool joined = false;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      if (groups[i].patches.empty() || groups[j].patches.empty()) continue;
      if (!may_be_copy(groups[i], groups[j], options) || !same_side(groups[i], groups[j]) ||
          !is_copy(groups[i], groups[j], patches, leaves, options))
        continue;
      absorb(groups[i], groups[j], patches, options);
      joined = true;
    }
  }
  heaviest_first(groups);
  return joined;
}

}  // namespace straightedge
