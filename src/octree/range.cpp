// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/near_points.hpp"
#include "octree/node_distance.hpp"
#include "straightedge/octree.hpp"

namespace straightedge {
namespace {

/// Counts all, keeps what fits.
template <class T>
void put(OctreeFound& found, std::span<T> out, const T& value) noexcept {
  if (found.found < out.size()) out[found.written++] = value;
  ++found.found;
}

Status status_of(const OctreeFound& found) noexcept {
  return found.written < found.found ? Status::output_full : Status::ok;
}

/// Cells that a point of the box can have. A point never has a lower cell than one below it, so a node
/// that is inside by its cells is inside by its points, and what the cells rule out is outside.
class CellRange {
 public:
  CellRange(const OctreeGrid& grid, const OctreeBox& box) noexcept {
    const Vector3 low = grid.in_cells(box.min), high = grid.in_cells(box.max);
    constexpr auto side = static_cast<double>(morton_side);
    empty_ = high.x < 0 || high.y < 0 || high.z < 0 || low.x >= side || low.y >= side || low.z >= side;
    low_ = {clamped(low.x), clamped(low.y), clamped(low.z)};
    high_ = {clamped(high.x), clamped(high.y), clamped(high.z)};
  }

  enum class Part : std::uint8_t { none, some, all };
  Part part_of(const OctreeNode& node) const noexcept {
    const MortonCell first = morton_decode(node.code());
    const std::uint32_t more = (std::uint32_t{1} << static_cast<unsigned>(node.level())) - 1;
    const MortonCell last{first.x + more, first.y + more, first.z + more};
    if (empty_ || last.x < low_.x || last.y < low_.y || last.z < low_.z || first.x > high_.x ||
        first.y > high_.y || first.z > high_.z) {
      return Part::none;
    }
    // The cells at the border of the range hold points of both kinds.
    const bool all = first.x > low_.x && first.y > low_.y && first.z > low_.z && last.x < high_.x &&
                     last.y < high_.y && last.z < high_.z;
    return all ? Part::all : Part::some;
  }

 private:
  static std::uint32_t clamped(double cell) noexcept {
    if (!(cell > 0)) return 0;
    return cell < static_cast<double>(morton_side) ? static_cast<std::uint32_t>(cell) : morton_side - 1;
  }
  MortonCell low_, high_;
  bool empty_ = false;
};

bool contains(const OctreeBox& box, const Vector3& p) noexcept {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z &&
         p.z <= box.max.z;
}

bool is_box(const OctreeBox& box) noexcept {
  return box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z;
}

}  // namespace

OctreeFound Octree::radius(const Vector3& position, double radius_m,
                           std::span<OctreeNeighbour> out) const noexcept {
  if (!prepared_) return {};
  if (!octree::is_position(position) || !(radius_m >= 0)) return {Status::invalid_option, 0, 0};
  OctreeFound found;
  const double most = radius_m * radius_m;
  const octree::NodeDistance distance(options_.grid, position);
  for (std::uint32_t i = 0; i < nodes_.size();) {
    const bool near = distance.squared(nodes_[i]) <= most;
    if (near && nodes_.is_leaf(i)) {
      octree::for_near_points(memory_.points, nodes_[i].first, nodes_[i + 1].first, position, most,
                              [&](const OctreeNeighbour& neighbour) { put(found, out, neighbour); });
    }
    i = near ? i + 1 : nodes_[i].next;
  }
  found.status = status_of(found);
  return found;
}

OctreeFound Octree::box(const OctreeBox& box, std::span<std::uint32_t> out) const noexcept {
  if (!prepared_) return {};
  if (!is_box(box)) return {Status::invalid_option, 0, 0};
  OctreeFound found;
  const CellRange range(options_.grid, box);
  for (std::uint32_t i = 0; i < nodes_.size();) {
    const CellRange::Part part = range.part_of(nodes_[i]);
    const bool descend = part == CellRange::Part::some && !nodes_.is_leaf(i);
    if (part != CellRange::Part::none && !descend) {
      const std::uint32_t end = nodes_[nodes_[i].next].first;
      for (std::uint32_t place = nodes_[i].first; place < end; ++place) {
        const OctreePoint p = point(place);
        if (part == CellRange::Part::all || contains(box, p.position())) put(found, out, p.index);
      }
    }
    i = descend ? i + 1 : nodes_[i].next;
  }
  found.status = status_of(found);
  return found;
}

OctreeFound Octree::ray(const OctreeRay& ray, std::span<OctreeCrossing> out) const noexcept {
  if (!prepared_) return {};
  OctreeFound found;
  OctreeRayWalk walk;
  found.status = walk.start(nodes_, options_.grid, ray);
  if (found.status != Status::ok) return found;
  for (OctreeCrossing crossing; walk.next(crossing);) put(found, out, crossing);
  found.status = status_of(found);
  return found;
}

OctreeFound Octree::first_hit(const OctreeRay& ray, OctreeCrossing& out) const noexcept {
  if (!prepared_) return {};
  OctreeRayWalk walk;
  const Status status = walk.start(nodes_, options_.grid, ray);
  const std::uint32_t found = status == Status::ok && walk.next(out) ? 1 : 0;
  return {status, found, found};
}

}  // namespace straightedge
