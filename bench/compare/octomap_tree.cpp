// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <octomap/OcTree.h>

#include <memory>

#include "peers.hpp"

namespace compare {

/// End points alone, without rays through free space and without occupancy of the inner nodes: the least that
/// it can do.
PointIndex octomap_tree(const Points& cloud, double leaf_m) {
  auto tree = std::make_shared<std::unique_ptr<octomap::OcTree>>();
  return {"OctoMap, end points",
          [tree, &cloud, leaf_m] {
            *tree = std::make_unique<octomap::OcTree>(leaf_m);
            constexpr bool occupied = true, lazy = true;
            for (std::size_t i = 0; i < cloud.size(); ++i)
              (*tree)->updateNode(octomap::point3d(cloud.x[i], cloud.y[i], cloud.z[i]), occupied, lazy);
          },
          nullptr, [tree] { return (*tree)->getNumLeafNodes(); }};
}

}  // namespace compare
