// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <pcl/octree/octree_search.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

#include "peers.hpp"

namespace compare {

PointIndex pcl_octree(const Points& cloud, double leaf_m) {
  using Tree = pcl::octree::OctreePointCloudSearch<pcl::PointXYZ>;
  auto points = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::size_t i = 0; i < cloud.size(); ++i) points->emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
  auto tree = std::make_shared<std::unique_ptr<Tree>>();
  return {"PCL octree",
          [points, tree, leaf_m] {
            *tree = std::make_unique<Tree>(leaf_m);
            (*tree)->setInputCloud(points);
            (*tree)->addPointsFromInputCloud();
          },
          [tree](const Points& positions, std::vector<double>& squared) {
            pcl::Indices indices(1);
            std::vector<float> distances(1);
            for (std::size_t i = 0; i < positions.size(); ++i) {
              const pcl::PointXYZ at(positions.x[i], positions.y[i], positions.z[i]);
              (*tree)->nearestKSearch(at, 1, indices, distances);
              squared[i] = static_cast<double>(distances[0]);
            }
          },
          nullptr};
}

}  // namespace compare
