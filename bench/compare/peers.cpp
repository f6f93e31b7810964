// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "peers.hpp"

namespace compare {
namespace {

[[maybe_unused]] bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

}  // namespace

std::vector<PlanePeer> first_plane_peers() {
  std::vector<PlanePeer> peers;
#ifdef COMPARE_PCL
  peers.push_back({"PCL RANSAC, packaged", pcl_first_plane});
#endif
#ifdef COMPARE_PCL_REBUILT
  if (has_avx2()) peers.push_back({"PCL RANSAC, rebuilt", pcl_rebuilt_first_plane});
#endif
#ifdef COMPARE_OPEN3D
  peers.push_back({"Open3D segment_plane", open3d_first_plane});
#endif
#ifdef COMPARE_CGAL
  peers.push_back({"CGAL Efficient RANSAC, normals given", cgal_first_plane});
#endif
  return peers;
}

std::vector<PlanePeer> all_planes_peers() {
  std::vector<PlanePeer> peers;
#ifdef COMPARE_RGBD
  peers.push_back({"OpenCV RgbdPlane", rgbd_planes, true});
#endif
#ifdef COMPARE_PCL
  peers.push_back({"PCL organised multi-plane", pcl_organized_planes, true});
  peers.push_back({"PCL sequential, packaged", pcl_all_planes});
#endif
#ifdef COMPARE_PCL_REBUILT
  if (has_avx2()) peers.push_back({"PCL sequential, rebuilt", pcl_rebuilt_all_planes});
#endif
#ifdef COMPARE_CGAL
  peers.push_back({"CGAL Efficient RANSAC, normals given", cgal_all_planes});
#endif
  return peers;
}

std::vector<PlanePeer> threaded_plane_peers() {
  std::vector<PlanePeer> peers;
#ifdef COMPARE_OPEN3D
  peers.push_back({"Open3D segment_plane", open3d_first_plane});
#endif
  return peers;
}

std::vector<PointIndex> point_indices([[maybe_unused]] const Points& cloud, [[maybe_unused]] double leaf_m) {
  std::vector<PointIndex> indices;
#ifdef COMPARE_OCTOMAP
  indices.push_back(octomap_tree(cloud, leaf_m));
#endif
#ifdef COMPARE_PCL
  indices.push_back(pcl_octree(cloud, leaf_m));
#endif
#ifdef COMPARE_FLANN
  indices.push_back(flann_tree(cloud));
#endif
  return indices;
}

}  // namespace compare
