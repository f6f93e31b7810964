// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_nodes.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge::octree {

/// Positions that squares do not overflow for.
constexpr bool is_position(const Vector3& p) noexcept {
  constexpr double most = 1e100;
  return p.x >= -most && p.x <= most && p.y >= -most && p.y <= most && p.z >= -most && p.z <= most;
}

// Two numbers that are treated alike, without a branch.
using Doubles2 = double __attribute__((vector_size(16)));

/// How near to a position a point of a node can be.
///
/// Boxes are compared in the cells' frame, where their borders are integers. A position in the cube or within
/// its size of it has an error of less than 2^-28 of a leaf there, so every side is moved out by that much.
/// What is farther away is less exact, but its distance is large, and all squares are taken 2^-40 smaller. So
/// the result is never above the computed distance of a point in the node.
class NodeDistance {
 public:
  NodeDistance(const OctreeGrid& grid, const Vector3& position) noexcept
      : scale_(grid.leaf_m * grid.leaf_m * (1 - 0x1p-40)) {
    const Vector3 at = grid.in_cells(position);
    x_ = widened(at.x);
    y_ = widened(at.y);
    z_ = widened(at.z);
  }

  double squared(const OctreeNode& node) const noexcept {
    const MortonCell cell = morton_decode(node.code());
    const double side = static_cast<double>(std::uint32_t{1} << static_cast<unsigned>(node.level()));
    const Vector3 gap{x_.gap(cell.x, side), y_.gap(cell.y, side), z_.gap(cell.z, side)};
    return squared_length(gap) * scale_;
  }

  /// The same for all octants of a node: each takes one of two halves along each axis.
  struct Octants {
    Doubles2 x, y, z;

    double squared(std::uint64_t octant) const noexcept {
      return x[octant & 1U] + y[octant >> 1U & 1U] + z[octant >> 2U & 1U];
    }
    std::uint32_t nearest() const noexcept {
      return (x[1] < x[0] ? 1U : 0U) | (y[1] < y[0] ? 2U : 0U) | (z[1] < z[0] ? 4U : 0U);
    }
  };
  Octants octants(const OctreeNode& inner) const noexcept {
    const MortonCell cell = morton_decode(inner.code());
    const std::uint32_t half = std::uint32_t{1} << static_cast<unsigned>(inner.level() - 1);
    return {x_.halves(cell.x, half) * scale_, y_.halves(cell.y, half) * scale_,
            z_.halves(cell.z, half) * scale_};
  }

 private:
  struct Range {
    double low = 0, high = 0;

    double gap(std::uint32_t cell, double side) const noexcept {
      // Signed: every processor has this conversion.
      const auto begin = static_cast<double>(static_cast<std::int32_t>(cell));
      const double below = begin - high;
      const double above = low - (begin + side);
      // One of them is 0; the sum needs no branch.
      return (below > 0 ? below : 0) + (above > 0 ? above : 0);
    }
    /// Squared gaps to the ranges of `half` cells from `cell` on and behind these.
    Doubles2 halves(std::uint32_t cell, std::uint32_t half) const noexcept {
      const auto begin = static_cast<double>(static_cast<std::int32_t>(cell));
      const auto side = static_cast<double>(static_cast<std::int32_t>(half));
      const Doubles2 begins{begin, begin + side};
      const Doubles2 below = begins - high;
      const Doubles2 above = low - (begins + side);
      const Doubles2 none{0, 0};
      const Doubles2 gaps = (below > none ? below : none) + (above > none ? above : none);
      return gaps * gaps;
    }
  };
  static Range widened(double at) noexcept { return {at - 0x1p-28, at + 0x1p-28}; }

  Range x_, y_, z_;
  double scale_;
};

}  // namespace straightedge::octree
