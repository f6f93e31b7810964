// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_nodes.hpp"
#include "straightedge/status.hpp"
#include "straightedge/vector3.hpp"

/// Every leaf that a ray crosses, in order.
///
///   1. Bring the ray into the cells' frame. It enters and leaves a node where it is inside of all three
///   pairs
///      of parallel faces at once: enter = the largest of the three entries, exit = the smallest exit.
///   2. Begin with the root. Of each node take the children that the ray crosses, nearest first: seen in the
///      ray's direction, an octant in front of another has no coordinate behind it, so the numbers
///      of the octants, with the bits of falling axes turned round, are an order from front to back.
///   3. A leaf is the next crossing. At most four of eight children are crossed, so the stack of those that
///   wait
///      holds at most 64 nodes.
///
/// Crossed means over more than a point: enter < exit. A ray that touches a corner or an edge crosses nothing
/// there; one that runs along a face, parallel to it, is in the upper of the two cells, as points on that
/// face are. The leaves are those that a walk from cell to cell through the grid would meet (Amanatides,
/// Woo), without the empty ones; empty space of any size costs one step.
///
/// J. Revelles, C. Urena, M. Lastra, "An Efficient Parametric Algorithm for Octree Traversal", WSCG 2000.
/// T. L. Kay, J. T. Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986, doi:10.1145/15886.15916 (step 1).
/// J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987,
/// doi:10.2312/egtp.19871000.
///
/// Time: leaves crossed times the height of the tree. Memory: 2 KB in the object.
namespace straightedge {

struct OctreeRay {
  Vector3 origin = {};     ///< metres, within 1e100 of 0; inside or outside the cube
  Vector3 direction = {};  ///< not null, finite; its length does not matter
  double max_distance_m = std::numeric_limits<double>::infinity();  ///< where the ray ends; 0 or more
};

struct OctreeCrossing {
  std::uint32_t leaf = 0;  ///< the node's number
  double enter_m = 0;      ///< metres along the ray; 0 when it starts inside
  double exit_m = 0;
};

/// The nodes must outlive the walk and stay as they are.
class OctreeRayWalk {
 public:
  /// `invalid_option`: the grid or a member of the ray is outside its range; there is nothing to walk then.
  Status start(const OctreeNodes& nodes, const OctreeGrid& grid, const OctreeRay& ray) noexcept;

  /// The next leaf; false, and `crossing` as it was, when there is none.
  bool next(OctreeCrossing& crossing) noexcept;

 private:
  struct Stretch {
    std::uint32_t node = 0;
    double enter = 0, exit = 0;  ///< in cells
  };
  bool crosses(std::uint32_t node, Stretch& stretch) const noexcept;
  void push_children(std::uint32_t node) noexcept;

  OctreeNodes nodes_;
  double leaf_m_ = 0;
  double origin_[3] = {};      ///< in cells
  double inverse_[3] = {};     ///< of the direction's components; 0 = parallel to the axis's faces
  double end_ = 0;             ///< in cells
  std::uint32_t falling_ = 0;  ///< bit 0, 1, 2: x, y, z falls along the ray
  std::uint32_t waiting_ = 0;
  Stretch stack_[64];
};

}  // namespace straightedge
