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

/// How near to a position a point of a node can be.
///
/// Boxes are compared in the cells' frame, where their borders are integers. A position in the cube or within
/// its size of it has an error of less than 2^-28 of a leaf there, and a gap one of less than 2^-29 more; so
/// every side is moved out by 2^-27. What is farther away is less exact, but its distance is large, and all
/// squares are taken 2^-40 smaller. So the result is never above the computed distance of a point in the
/// node.
class NodeDistance {
 public:
  NodeDistance(const OctreeGrid& grid, const Vector3& position) noexcept
      : at_(grid.in_cells(position)), scale_(grid.leaf_m * grid.leaf_m * (1 - 0x1p-40)) {}

  const Vector3& in_cells() const noexcept { return at_; }

  double squared(const OctreeNode& node) const noexcept {
    const MortonCell cell = morton_decode(node.code());
    const double side = static_cast<double>(std::uint32_t{1} << static_cast<unsigned>(node.level()));
    const Vector3 gaps{gap(at_.x, cell.x, side), gap(at_.y, cell.y, side), gap(at_.z, cell.z, side)};
    return squared_length(gaps) * scale_;
  }

  /// The same for all octants of a node: each takes one of two halves along each axis.
  struct Octants {
    double x[2], y[2], z[2];

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
    const double side = static_cast<double>(static_cast<std::int32_t>(half));
    const auto scaled = [this, side](double at, std::uint32_t begin) {
      const double g = gap(at, begin, side);
      return g * g * scale_;
    };
    return {{scaled(at_.x, cell.x), scaled(at_.x, cell.x + half)},
            {scaled(at_.y, cell.y), scaled(at_.y, cell.y + half)},
            {scaled(at_.z, cell.z), scaled(at_.z, cell.z + half)}};
  }

  /// Of what is so many cells away along an axis.
  double squared(double cells) const noexcept { return cells * cells * scale_; }
  /// A little more squares of `units` a cell than a square metre has.
  double squares_a_m(double units) const noexcept { return units * units * (1 + 0x1p-12) / scale_; }

 private:
  /// From a coordinate to the cells from `begin` on, so many as `side`.
  static double gap(double at, std::uint32_t begin, double side) noexcept {
    // Signed: every processor has this conversion.
    const double middle = static_cast<double>(static_cast<std::int32_t>(begin)) + 0.5 * side;
    const double beyond = __builtin_fabs(at - middle) - (0.5 * side + 0x1p-27);
    return 0.5 * (beyond + __builtin_fabs(beyond));  // 0 when negative, without a branch
  }

  Vector3 at_;
  double scale_;
};

}  // namespace straightedge::octree
