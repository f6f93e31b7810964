// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/planes_first.hpp"
#include "cli/planes_run.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge::cli {

/// What one thread keeps from frame to frame: detectors for frames of one size, and the map of the frames
/// that it saw.
class PlanesWorker {
 public:
  PlanesWorker(const PlanesArguments& arguments, const DepthCamera& camera, const KernelSet& kernels);

  /// The frame through every method, into the maps. Failures name its file. The size must be that of the
  /// frames before, if there is one; else it is set.
  Result<std::vector<MethodFrame>> take(const SequenceFrame& frame, Size& size);

  PlaneMapBuilder& builder(std::size_t method) { return builders_[method]; }

 private:
  Result<Done> make_detectors(const SequenceFrame& frame, Size size);
  Result<std::vector<MethodFrame>> look_at(const DepthView& depth, const Pose& pose);

  const PlanesArguments* arguments_;
  const KernelSet* kernels_;
  const DepthCamera* camera_;
  Size size_;                ///< that the detectors are for
  DetectedPlanes detected_;  ///< its memory is used for every frame
  std::vector<PlaneDetector> detectors_;
  std::vector<FirstPlane> first_;  ///< empty for a single method
  std::vector<PlaneMapBuilder> builders_;
};

}  // namespace straightedge::cli
