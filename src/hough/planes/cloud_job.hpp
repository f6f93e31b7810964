// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_planes.hpp"

namespace straightedge::hough {

/// What the steps of hough_planes.hpp read and write in one run.
struct CloudJob {
  const PointsView& points;
  const HoughPlaneOptions& options;
  detail::HoughPlaneMemory& memory;
  std::span<std::uint16_t> labels;  ///< 0: free
  std::span<FoundPlane> planes;
  HoughPlaneTrace trace;
  Vector3 origin;
  std::size_t left = 0;  ///< free points, the first of the memory's lists
  std::uint32_t found = 0;
  std::uint32_t votes = 0;
  bool confident = true;

  Vector3 at(std::size_t i) const noexcept {
    return {static_cast<double>(memory.x[i]), static_cast<double>(memory.y[i]),
            static_cast<double>(memory.z[i])};
  }
  Plane in_input_frame(const Plane& plane) const noexcept {
    return canonical({plane.normal, plane.distance + dot(plane.normal, origin)});
  }
};

/// Step 4. `plane` is relative to the origin. True: planes[found] is a plane, and so many free points are
/// labelled found + 1; the caller counts it.
bool refit_peak(CloudJob& job, const Plane& plane) noexcept;

/// Step 5, the list: takes out points that have a label.
void drop_labelled(CloudJob& job) noexcept;

/// Steps 2 to 5.
Status vote_standard(CloudJob& job) noexcept;
/// Steps 2 to 6.
Status vote_randomized(CloudJob& job) noexcept;

}  // namespace straightedge::hough
