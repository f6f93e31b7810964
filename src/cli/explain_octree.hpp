// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/octree.hpp"

namespace straightedge::cli {

/// The points of a depth frame in an octree. Frames without readings have no tree.
struct OctreeStage {
  std::unique_ptr<std::byte[]> memory;
  Octree octree;
  OctreeBox box;             ///< of the points; the camera is at 0
  std::uint32_t points = 0;  ///< in the tree
};
OctreeStage build_octree(const DepthView& depth);

// Seen from above: x goes to the right, depth upwards.

struct OctreeLevelPicture {
  Image<Rgb> picture;
  std::uint32_t nodes = 0;
  double side_m = 0;
};
/// The nodes of a level; the more readings stand over one another, the brighter. Needs points.
OctreeLevelPicture show_octree_level(const OctreeStage& stage, int level);

/// Which nodes a question for all points in a ball looks at; drawn are those at the height of its middle.
/// Needs points.
struct OctreeQuestionPicture {
  Image<Rgb> picture;
  Vector3 place;  ///< where the camera's look into the middle of the points ends
  double radius_m = 0;
  std::uint32_t passed_nodes = 0, passed_points = 0;  ///< too far away as a whole
  std::uint32_t leaves = 0, leaf_points = 0;          ///< whose points are asked one by one
  std::uint32_t found = 0;
};
OctreeQuestionPicture show_octree_question(const OctreeStage& stage);

}  // namespace straightedge::cli
