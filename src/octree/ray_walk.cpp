// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/node_distance.hpp"
#include "straightedge/octree_ray.hpp"

namespace straightedge {
namespace {

double magnitude(double a) noexcept {
  return a < 0 ? -a : a;
}

/// Divided by the largest component first, so that no square overflows or vanishes; null stays null.
Vector3 unit(const Vector3& direction) noexcept {
  double largest = magnitude(direction.x);
  if (magnitude(direction.y) > largest) largest = magnitude(direction.y);
  if (magnitude(direction.z) > largest) largest = magnitude(direction.z);
  if (!(largest > 0)) return {};
  return normalized({direction.x / largest, direction.y / largest, direction.z / largest});
}

/// A direction this flat moves by nothing over any distance in range.
constexpr double parallel = 1e-250;

/// Where a ray is between two parallel faces; empty is enter >= exit.
void cut(double origin, double inverse, double low, double high, double& enter, double& exit) noexcept {
  if (inverse == 0) {
    if (!(origin >= low && origin < high)) exit = enter;
    return;
  }
  const double in = ((inverse > 0 ? low : high) - origin) * inverse;
  const double out = ((inverse > 0 ? high : low) - origin) * inverse;
  if (in > enter) enter = in;
  if (out < exit) exit = out;
}

}  // namespace

Status OctreeRayWalk::start(const OctreeNodes& nodes, const OctreeGrid& grid, const OctreeRay& ray) noexcept {
  waiting_ = 0;
  const Vector3 direction = unit(ray.direction);
  if (!grid.valid() || !octree::is_position(ray.origin) || !finite(ray.direction) || direction == Vector3{} ||
      !(ray.max_distance_m >= 0)) {
    return Status::invalid_option;
  }

  // Step 1
  nodes_ = nodes;
  leaf_m_ = grid.leaf_m;
  end_ = ray.max_distance_m / grid.leaf_m;
  const Vector3 origin = grid.in_cells(ray.origin);
  const double origins[] = {origin.x, origin.y, origin.z};
  const double directions[] = {direction.x, direction.y, direction.z};
  falling_ = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    origin_[axis] = origins[axis];
    inverse_[axis] = magnitude(directions[axis]) < parallel ? 0 : 1 / directions[axis];
    if (inverse_[axis] < 0) falling_ |= 1U << axis;
  }
  if (nodes.size() > 0 && crosses(0, stack_[0])) waiting_ = 1;
  return Status::ok;
}

bool OctreeRayWalk::crosses(std::uint32_t node, Stretch& stretch) const noexcept {
  const MortonCell cell = morton_decode(nodes_[node].code());
  const std::uint32_t side = std::uint32_t{1} << static_cast<unsigned>(nodes_[node].level());
  const std::uint32_t low[] = {cell.x, cell.y, cell.z};
  stretch = {node, 0, end_};
  for (unsigned axis = 0; axis < 3; ++axis) {
    cut(origin_[axis], inverse_[axis], static_cast<double>(low[axis]), static_cast<double>(low[axis] + side),
        stretch.enter, stretch.exit);
  }
  return stretch.enter < stretch.exit;
}

void OctreeRayWalk::push_children(std::uint32_t parent) noexcept {
  const auto shift = static_cast<unsigned>(3 * (nodes_[parent].level() - 1));
  Stretch crossed[8];
  bool is_crossed[8] = {};
  for (std::uint32_t child = parent + 1; child < nodes_[parent].next; child = nodes_[child].next) {
    const auto octant = static_cast<std::uint32_t>(nodes_[child].code() >> shift & 7U) ^ falling_;
    is_crossed[octant] = crosses(child, crossed[octant]);
  }
  // The last first, so that the nearest comes to lie on top.
  for (std::uint32_t octant = 8; octant-- > 0;)
    if (is_crossed[octant]) stack_[waiting_++] = crossed[octant];
}

bool OctreeRayWalk::next(OctreeCrossing& crossing) noexcept {
  while (waiting_ > 0) {
    const Stretch stretch = stack_[--waiting_];

    // Step 3
    if (nodes_.is_leaf(stretch.node)) {
      crossing = {stretch.node, stretch.enter * leaf_m_, stretch.exit * leaf_m_};
      return true;
    }

    // Step 2
    push_children(stretch.node);
  }
  return false;
}

}  // namespace straightedge
