// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_detector.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace straightedge {
namespace {

constexpr std::size_t most_proposed = 256;

Failure refused(Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::bad_content, to_string(status)};
}

std::uint32_t search_ransac(void* user, ImageView<const float> inverse_depth,
                            ImageView<const std::uint16_t> labels, const PinholeCamera& /*camera*/,
                            std::span<ProposedPlane> out) noexcept {
  std::array<PlaneCandidate, most_proposed> found;
  const auto room = std::span(found).first(std::min(found.size(), out.size()));
  const RansacSearchResult result = static_cast<RansacSearch*>(user)->run(inverse_depth, labels, room);
  for (std::uint32_t i = 0; i < result.candidates; ++i) {
    out[i] = {.fit = found[i].fit, .score = found[i].score, .iterations = result.draws};
  }
  return result.candidates;
}

struct HoughUser {
  HoughPatchSearch* search;
  const PlaneGate* gate;
};

std::uint32_t search_hough(void* user, ImageView<const float> inverse_depth,
                           ImageView<const std::uint16_t> labels, const PinholeCamera& camera,
                           std::span<ProposedPlane> out) noexcept {
  const auto& [search, gate] = *static_cast<HoughUser*>(user);
  std::array<HoughPlaneCandidate, most_proposed> found;
  const auto room = std::span(found).first(std::min(found.size(), out.size()));
  const HoughPatchResult result = search->run(inverse_depth, camera, *gate, labels, room);
  for (std::uint32_t i = 0; i < result.candidates; ++i) {
    out[i] = {.fit = found[i].fit, .score = static_cast<double>(found[i].votes), .iterations = result.votes};
  }
  return result.candidates;
}

}  // namespace

Result<PlaneDetector> PlaneDetector::create(Size size, const PlaneDetectorOptions& options) {
  PlaneDetector made;
  made.options_ = options;
  made.options_.ransac.gate = widened(options.frame);
  const std::uint32_t least = least_pixels(size, options.frame);
  made.options_.ransac.min_pixels = std::min(options.ransac.min_pixels, static_cast<std::int32_t>(least));
  made.options_.hough.min_pixels = std::min(options.hough.min_pixels, least);
  made.frame_ = std::make_unique<FramePlanes>();
  made.ransac_ = std::make_unique<RansacSearch>();
  made.hough_ = std::make_unique<HoughPatchSearch>();
  const bool ransac = options.method == PlaneMethod::ransac;
  const std::size_t frame_bytes = FramePlanes::workspace_bytes(size, options.frame);
  const std::size_t search_bytes = ransac ? RansacSearch::workspace_bytes(size, made.options_.ransac)
                                          : HoughPatchSearch::workspace_bytes(size, made.options_.hough);
  if (search_bytes == 0) return refused(Status::invalid_option);
  // Options that are out of range must not decide how much memory is taken.
  const Status checked = made.frame_->prepare(size, options.frame, {});
  if (checked != Status::workspace_too_small) return refused(checked);
  made.memory_.resize(frame_bytes + search_bytes);
  const std::span<std::byte> bytes = made.memory_;
  const Status frame = made.frame_->prepare(size, options.frame, bytes.first(frame_bytes));
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
  const PlaneGate gate = widened(options_.frame);
  HoughUser hough{hough_.get(), &gate};
  const bool ransac = options_.method == PlaneMethod::ransac;
  const PlaneSearch search =
      ransac ? PlaneSearch{ransac_.get(), search_ransac} : PlaneSearch{&hough, search_hough};
  const Status status = frame_->run(depth, search, result.labels.view(), result.planes, result.found);
  if (status != Status::ok) return refused(status);
  if (ransac) result.found.seed = options_.ransac.seed;
  result.planes.resize(result.found.planes);
  return result;
}

Result<DetectedPlanes> detect_planes(const DepthView& depth, const PlaneDetectorOptions& options) {
  auto detector = PlaneDetector::create(depth.raw.size(), options);
  if (!detector) return detector.failure();
  return detector->detect(depth);
}

}  // namespace straightedge
