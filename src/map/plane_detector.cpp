// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_detector.hpp"

#include <span>
#include <string>

namespace straightedge {
namespace {

Failure refused(Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::bad_content, to_string(status)};
}

}  // namespace

Result<PlaneDetector> PlaneDetector::create(Size size, const PlaneDetectorOptions& options,
                                            const KernelSet& kernels) {
  PlaneDetector made;
  made.options_ = options;
  made.options_.ransac = for_frame(options.ransac, size, options.frame);
  made.options_.hough = for_frame(options.hough, size, options.frame);
  made.options_.frame.kernels = kernels.depth;
  made.options_.ransac.kernels = kernels.plane_search;
  made.options_.hough.kernels = kernels.hough_patches;
  made.frame_ = std::make_unique<FramePlanes>();
  made.ransac_ = std::make_unique<RansacSearch>();
  made.hough_ = std::make_unique<HoughPatchSearch>();
  const bool ransac = options.method == PlaneMethod::ransac;
  const std::size_t frame_bytes = FramePlanes::workspace_bytes(size, made.options_.frame);
  const std::size_t search_bytes = ransac ? RansacSearch::workspace_bytes(size, made.options_.ransac)
                                          : HoughPatchSearch::workspace_bytes(size, made.options_.hough);
  if (search_bytes == 0) return refused(Status::invalid_option);
  // Options that are out of range must not decide how much memory is taken.
  const Status checked = made.frame_->prepare(size, made.options_.frame, {});
  if (checked != Status::workspace_too_small) return refused(checked);
  made.memory_.resize(frame_bytes + search_bytes);
  const std::span<std::byte> bytes = made.memory_;
  const Status frame = made.frame_->prepare(size, made.options_.frame, bytes.first(frame_bytes));
  if (frame != Status::ok) return refused(frame);
  const Status search =
      ransac ? RansacSearch::prepare(*made.ransac_, size, made.options_.ransac, bytes.subspan(frame_bytes))
             : HoughPatchSearch::prepare(*made.hough_, size, made.options_.hough, bytes.subspan(frame_bytes));
  if (search != Status::ok) return refused(search);
  return made;
}

Result<DetectedPlanes> PlaneDetector::detect(const DepthView& depth) {
  if (!depth.valid()) return refused(Status::invalid_image);
  DetectedPlanes result;
  result.labels = Image<std::uint16_t>(depth.raw.size());
  result.planes.resize(options_.frame.max_planes);
  const bool ransac = options_.method == PlaneMethod::ransac;
  const PlaneSearch search = ransac ? plane_search(*ransac_) : plane_search(*hough_);
  const Status status = frame_->run(depth, search, result.labels.view(), result.planes, result.found);
  if (status != Status::ok) return refused(status);
  if (ransac) result.found.seed = options_.ransac.seed;
  result.planes.resize(result.found.planes);
  return result;
}

Result<DetectedPlanes> detect_planes(const DepthView& depth, const PlaneDetectorOptions& options,
                                     const KernelSet& kernels) {
  auto detector = PlaneDetector::create(depth.raw.size(), options, kernels);
  if (!detector) return detector.failure();
  return detector->detect(depth);
}

}  // namespace straightedge
