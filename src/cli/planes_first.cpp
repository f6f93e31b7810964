// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_first.hpp"

#include <array>
#include <chrono>

#include "straightedge/host/kernels.hpp"

namespace straightedge::cli {
namespace {

Failure refused(Status status) {
  return {Problem::bad_option, to_string(status)};
}

}  // namespace

Result<FirstPlane> FirstPlane::create(Size size, const PlaneDetectorOptions& options,
                                      const KernelSet& kernels) {
  FirstPlane made;
  made.options_ = options;
  made.ransac_ = std::make_unique<RansacPlanes>();
  made.hough_ = std::make_unique<HoughPatchSearch>();
  const bool ransac = options.method == PlaneMethod::ransac;
  RansacOptions one;
  one.gate = options.frame.gate;
  one.seed = options.ransac.seed;
  one.kernels = kernels.ransac;
  if (!ransac) made.inverse_depth_ = Image<float>(size);
  HoughPatchOptions& hough = made.options_.hough;
  hough.max_candidates = 1;
  hough.rounds = 1;
  hough.kernels = kernels.depth;
  hough.gate = options.frame.gate;
  const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  made.memory_.resize(ransac ? RansacPlanes::workspace_bytes(pixels, one)
                             : HoughPatchSearch::workspace_bytes(size, hough));
  const Status status = ransac ? RansacPlanes::prepare(*made.ransac_, pixels, one, made.memory_)
                               : HoughPatchSearch::prepare(*made.hough_, size, hough, made.memory_);
  if (status != Status::ok) return refused(status);
  return made;
}

double FirstPlane::time(const DepthView& depth) {
  std::array<FoundPlane, 1> plane;
  std::array<ProposedPlane, 1> candidate;
  const auto before = std::chrono::steady_clock::now();
  // A frame that a method refuses was refused by the search for all planes, which came before.
  if (options_.method == PlaneMethod::ransac) {
    (void)ransac_->run(depth, plane, {});
  } else {
    (void)inverse_depth_image(depth, inverse_depth_.view());
    (void)hough_->run(inverse_depth_, depth.camera, {}, candidate);
  }
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - before;
  return time.count();
}

}  // namespace straightedge::cli
