// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/morton.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/status.hpp"
#include "straightedge/vector3.hpp"

/// Where the cells of an octree lie in space.
///
///   cell = floor((x - origin) / leaf_m) + 699 050, for each axis                                   (1)
///
/// The cube has 2^21 cells a side; `origin` is a corner between cells a third of the way into it: it
/// reaches 699 050 cells down and 1 398 102 up (at 5 cm: 35 and 70 km). A third is 010101... in binary, so
/// what lies round the origin shares nearly all of its code's leading bits. In the middle of the
/// cube, where the largest nodes meet, it would share none, and trees would be higher and slower to sort.
///
/// A point on the border of two cells belongs to the upper one. (1) is computed in doubles, in which it is
/// monotone: of two points the one with the larger x never has the smaller cell.
namespace straightedge {

inline constexpr std::uint32_t octree_origin_cell = 699'050;

/// Closed.
struct OctreeBox {
  Vector3 min;
  Vector3 max;
};

struct OctreeGrid {
  Vector3 origin = {};   ///< metres, within 1e42 of 0
  double leaf_m = 0.05;  ///< side of a cell of the finest level, metres, 1e-9 to 1e35

  constexpr bool valid() const noexcept {
    return leaf_m >= 1e-9 && leaf_m <= 1e35 && coordinate(origin.x) && coordinate(origin.y) &&
           coordinate(origin.z);
  }

  /// Equation (1) without the floor.
  constexpr Vector3 in_cells(const Vector3& point) const noexcept {
    const double scale = 1 / leaf_m;
    constexpr double o = octree_origin_cell;
    return {(point.x - origin.x) * scale + o, (point.y - origin.y) * scale + o,
            (point.z - origin.z) * scale + o};
  }
  /// False: the point lies outside the cube or is not finite, and `cell` is left as it was.
  constexpr bool cell_of(const Vector3& point, MortonCell& cell) const noexcept {
    const Vector3 at = in_cells(point);
    if (!(in_cube(at.x) && in_cube(at.y) && in_cube(at.z))) return false;
    // Through signed integers, which every processor converts to in one step.
    cell = {static_cast<std::uint32_t>(static_cast<std::int32_t>(at.x)),
            static_cast<std::uint32_t>(static_cast<std::int32_t>(at.y)),
            static_cast<std::uint32_t>(static_cast<std::int32_t>(at.z))};
    return true;
  }

  /// The cube of the node at `level` (0 = leaf to 21 = everything) in which the cell lies.
  constexpr OctreeBox box_of(std::uint64_t code, int level) const noexcept {
    const MortonCell cell = morton_decode(morton_ancestor(code, level));
    const double side = static_cast<double>(std::uint32_t{1} << static_cast<unsigned>(level));
    const Vector3 low{static_cast<double>(cell.x), static_cast<double>(cell.y), static_cast<double>(cell.z)};
    return {in_metres(low), in_metres(low + Vector3{side, side, side})};
  }
  constexpr Vector3 in_metres(const Vector3& cells) const noexcept {
    constexpr double o = octree_origin_cell;
    return origin + leaf_m * (cells - Vector3{o, o, o});
  }

 private:
  static constexpr bool coordinate(double c) noexcept { return c >= -1e42 && c <= 1e42; }
  static constexpr bool in_cube(double c) noexcept { return c >= 0 && c < static_cast<double>(morton_side); }
};

struct OctreeFit {
  Status status = Status::invalid_image;  ///< `invalid_image`: no view, or no finite point in it
  OctreeGrid grid;
  OctreeBox box;             ///< of the finite points
  std::uint32_t points = 0;  ///< finite ones
};

/// A grid that holds all finite points of a cloud, with the smallest corner of their box in the middle of a
/// cell before which large nodes end, so that the tree is no higher than the cloud's extent asks for. Leaves
/// are doubled in size until the box is at most 2^20 of them wide. `invalid_option`: leaf_m is out of its
/// range. Time: one pass over the points.
OctreeFit fit_octree_grid(const PointsView& points, double leaf_m) noexcept;

}  // namespace straightedge
