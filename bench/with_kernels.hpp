// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/ransac_planes.hpp"

/// The library's calls with the kernels of a set.
namespace bench {

/// Options with those kernels of the set that are theirs: found by type.
template <class Options, class Set>
Options with_kernels(Options options, const Set& set) {
  if constexpr (requires { options.kernels = set.canny_rows; }) options.kernels = set.canny_rows;
  if constexpr (requires { options.kernels = set.hough; }) options.kernels = set.hough;
  if constexpr (requires { options.kernels = set.ransac; }) options.kernels = set.ransac;
  if constexpr (requires { options.kernels = set.depth; }) options.kernels = set.depth;
  if constexpr (requires { options.kernels = set.plane_search; }) options.kernels = set.plane_search;
  return options;
}

/// RANSAC to the first plane, from a frame as the camera gives it or from a cloud.
class FirstPlane {
 public:
  FirstPlane(std::size_t readings, const straightedge::RansacOptions& options,
             const straightedge::KernelSet& set)
      : memory_(straightedge::RansacPlanes::workspace_bytes(readings, with_kernels(options, set))) {
    prepared_ = straightedge::RansacPlanes::prepare(ransac_, readings, with_kernels(options, set), memory_);
  }

  straightedge::RansacPlanesResult run(const straightedge::DepthView& depth) {
    return ransac_.run(depth, plane_, {});
  }
  straightedge::RansacPlanesResult run(const straightedge::PointsView& cloud) {
    return ransac_.run(cloud, plane_, {});
  }
  /// Of the last run that found one.
  const straightedge::Plane& plane() const { return plane_[0].fit.plane; }
  bool prepared() const { return prepared_ == straightedge::Status::ok; }

 private:
  std::vector<std::byte> memory_;
  straightedge::RansacPlanes ransac_;
  straightedge::Status prepared_;
  std::vector<straightedge::FoundPlane> plane_ = std::vector<straightedge::FoundPlane>(1);
};

}  // namespace bench
