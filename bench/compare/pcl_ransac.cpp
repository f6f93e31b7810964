// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Compiled twice. Linked to the packaged library, whose templates were compiled for plain x86-64; and, as
// pcl_rebuilt_..., with PCL's templates compiled here for AVX2, in a library that hides them, so that the
// linker cannot take one for the other.
#include <pcl/filters/extract_indices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <memory>
#include <utility>

#include "peers.hpp"

#ifdef COMPARE_PCL_REBUILT
#include <pcl/filters/impl/extract_indices.hpp>
#include <pcl/segmentation/impl/sac_segmentation.hpp>
#define COMPARE_JOB(name) __attribute__((visibility("default"))) FindPlanes pcl_rebuilt_##name
#else
#define COMPARE_JOB(name) FindPlanes pcl_##name
#endif

namespace compare {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr pcl_cloud(const Points& points) {
  auto cloud = std::make_shared<Cloud>();
  for (std::size_t i = 0; i < points.size(); ++i) cloud->emplace_back(points.x[i], points.y[i], points.z[i]);
  return cloud;
}

pcl::SACSegmentation<pcl::PointXYZ> segmentation() {
  pcl::SACSegmentation<pcl::PointXYZ> search;
  search.setModelType(pcl::SACMODEL_PLANE);
  search.setMethodType(pcl::SAC_RANSAC);
  search.setMaxIterations(pcl_iterations);
  search.setDistanceThreshold(gate_m);
  search.setOptimizeCoefficients(true);
  return search;
}

straightedge::Plane plane_of(const pcl::ModelCoefficients& c) {
  return {{c.values[0], c.values[1], c.values[2]}, -static_cast<double>(c.values[3])};
}

}  // namespace

COMPARE_JOB(first_plane)(const Scene& scene) {
  const Cloud::Ptr cloud = pcl_cloud(scene.cloud);
  return [cloud] {
    pcl::SACSegmentation<pcl::PointXYZ> search = segmentation();
    search.setInputCloud(cloud);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    search.segment(inliers, coefficients);
    if (inliers.indices.empty()) return PlanesOfScene();
    return PlanesOfScene{{plane_of(coefficients)}, inliers.indices.size()};
  };
}

COMPARE_JOB(all_planes)(const Scene& scene) {
  const Cloud::Ptr cloud = pcl_cloud(scene.cloud);
  return [cloud] {
    pcl::SACSegmentation<pcl::PointXYZ> search = segmentation();
    PlanesOfScene found;
    for (Cloud::Ptr rest = cloud;;) {
      search.setInputCloud(rest);
      const pcl::PointIndices::Ptr inliers = std::make_shared<pcl::PointIndices>();
      pcl::ModelCoefficients coefficients;
      search.segment(*inliers, coefficients);
      if (static_cast<double>(inliers->indices.size()) < least_share * static_cast<double>(cloud->size()))
        return found;
      found.planes.push_back(plane_of(coefficients));
      found.labelled += inliers->indices.size();
      pcl::ExtractIndices<pcl::PointXYZ> extract;
      extract.setInputCloud(rest);
      extract.setIndices(inliers);
      extract.setNegative(true);
      auto others = std::make_shared<Cloud>();
      extract.filter(*others);
      rest = std::move(others);
    }
  };
}

}  // namespace compare
