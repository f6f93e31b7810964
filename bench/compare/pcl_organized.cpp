// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <pcl/features/integral_image_normal.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <memory>

#include "peers.hpp"

namespace compare {

FindPlanes pcl_organized_planes(const Scene& scene) {
  const Points& p = scene.picture;
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::size_t i = 0; i < p.size(); ++i) cloud->emplace_back(p.x[i], p.y[i], p.z[i]);
  cloud->width = static_cast<std::uint32_t>(p.width);
  cloud->height = static_cast<std::uint32_t>(p.size() / cloud->width);
  cloud->is_dense = false;
  const auto least = static_cast<unsigned>(least_share * static_cast<double>(scene.cloud.size()));
  return [cloud, least] {
    auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
    estimation.setMaxDepthChangeFactor(0.02F);
    estimation.setNormalSmoothingSize(20.0F);
    estimation.setInputCloud(cloud);
    estimation.compute(*normals);

    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
    segmentation.setMinInliers(least);
    segmentation.setAngularThreshold(3 * 3.14159265358979 / 180);
    segmentation.setDistanceThreshold(gate_m);
    segmentation.setInputNormals(normals);
    segmentation.setInputCloud(cloud);
    std::vector<pcl::PlanarRegion<pcl::PointXYZ>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
        regions;
    segmentation.segmentAndRefine(regions);
    PlanesOfScene found;
    for (auto& region : regions) {
      const Eigen::Vector4f c = region.getCoefficients();
      found.planes.push_back({{c[0], c[1], c[2]}, -static_cast<double>(c[3])});
      found.labelled += region.getCount();
    }
    return found;
  };
}

}  // namespace compare
