// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene.hpp"
#include "straightedge/plane.hpp"

/// What other libraries do, each in a file of its own that is built where the library was found. A function
/// that makes a job brings the input into the library's own form; calling the job is what takes the time.
namespace compare {

using Planes = std::vector<straightedge::Plane>;
struct PlanesOfScene {
  Planes planes;
  std::size_t labelled = 0;  ///< readings that the library says lie on them
};
using FindPlanes = std::function<PlanesOfScene()>;

/// Readings this near to a plane are the plane's, for everybody.
inline constexpr double gate_m = 0.02;
/// The least share of the readings that all-planes jobs ask for.
inline constexpr double least_share = 0.05;
/// Hypotheses of PCL.
inline constexpr int pcl_iterations = 200;

struct PlanePeer {
  std::string name;
  FindPlanes (*make)(const Scene&) = nullptr;
  /// Finds connected surfaces, as we do: we have to label as many readings.
  bool same_job = false;
};
std::vector<PlanePeer> first_plane_peers();
std::vector<PlanePeer> all_planes_peers();
/// Those of both kinds that can use several threads.
std::vector<PlanePeer> threaded_plane_peers();

// An octree of points, or what takes its place: `build` makes it anew, `nearest` asks for the nearest point
// of each position, one after another.
struct PointIndex {
  std::string name;
  std::function<void()> build;
  /// Squared distances in metres; null when it has no such question.
  std::function<void(const Points&, std::vector<double>&)> nearest;
  /// How many leaves it has after `build`; null when its cells are others than ours.
  std::function<std::size_t()> leaves;
};
/// Leaves of `leaf_m` metres, where there are leaves.
std::vector<PointIndex> point_indices(const Points& cloud, double leaf_m);

FindPlanes pcl_first_plane(const Scene& scene);          // as packaged
FindPlanes pcl_rebuilt_first_plane(const Scene& scene);  // the same text, compiled for AVX2
FindPlanes pcl_all_planes(const Scene& scene);
FindPlanes pcl_rebuilt_all_planes(const Scene& scene);
FindPlanes pcl_organized_planes(const Scene& scene);
PointIndex pcl_octree(const Points& cloud, double leaf_m);
FindPlanes open3d_first_plane(const Scene& scene);
FindPlanes cgal_first_plane(const Scene& scene);
FindPlanes cgal_all_planes(const Scene& scene);
FindPlanes rgbd_planes(const Scene& scene);
PointIndex octomap_tree(const Points& cloud, double leaf_m);
PointIndex flann_tree(const Points& cloud);

}  // namespace compare
