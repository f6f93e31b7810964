// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/ransac_planes.hpp"

namespace straightedge::cli {

/// How long a method takes from a depth frame to its first plane, when no other is asked for: RANSAC's best
/// plane of the whole frame, or the highest peak of one voting of patches.
class FirstPlane {
 public:
  static Result<FirstPlane> create(Size size, const PlaneDetectorOptions& options, const KernelSet& kernels);

  /// Milliseconds.
  double time(const DepthView& depth);

 private:
  FirstPlane() = default;

  PlaneDetectorOptions options_;
  Image<float> inverse_depth_;
  std::vector<std::byte> memory_;
  std::unique_ptr<RansacPlanes> ransac_;
  std::unique_ptr<HoughPatchSearch> hough_;
};

}  // namespace straightedge::cli
