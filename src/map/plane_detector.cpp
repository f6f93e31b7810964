// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_detector.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace straightedge {
namespace {

Failure refused(Status status) {
  const bool option = status == Status::invalid_option || status == Status::too_large;
  return {option ? Problem::bad_option : Problem::bad_content, to_string(status)};
}

/// A plane is seen well in so many cells of the picture's grid.
constexpr std::uint32_t search_cells = 180, label_cells = 60;
// Patches that know their normal worse only spread votes: a large plane has some that know it well.
constexpr double large_spread_rad = 0.12;
// Large planes differ in direction, or lie one behind the other.
constexpr HoughAccumulatorOptions large_votes{HoughCells::ball, 24, 96};

/// The largest of the cells 4, 8, ... `most` of which the smallest plane still has enough.
std::int32_t coarsest_cell(std::uint32_t min_pixels, std::uint32_t cells, std::int32_t most) noexcept {
  std::int32_t cell = 4;
  while (cell < most && min_pixels / static_cast<std::uint32_t>(4 * cell * cell) >= cells) cell *= 2;
  return cell;
}

}  // namespace

PlaneDetectorOptions for_large_planes(PlaneDetectorOptions options, Size size, double share) noexcept {
  const FramePlanesOptions large = for_large_planes(size, share);
  options.frame.min_pixels = large.min_pixels;
  options.frame.rounds = large.rounds;
  options.frame.slack = std::max(options.frame.slack, large.slack);
  options.frame.cell = coarsest_cell(large.min_pixels, label_cells, large.cell);
  // A search sees less of a plane than is labelled in the end, and RANSAC looks for it in windows that are not
  // smaller than the smallest plane: most of such a window ought to be its own.
  const std::uint32_t quarter = large.min_pixels / 4;
  options.ransac.min_pixels = static_cast<std::int32_t>(quarter);
  options.ransac.cell = coarsest_cell(large.min_pixels, search_cells, 16);
  options.hough.min_pixels = quarter;
  options.hough.smallest_patch = 2 * options.frame.cell;
  options.hough.max_spread_rad = large_spread_rad;
  options.hough.accumulator = large_votes;
  return options;
}

Result<PlaneDetector> PlaneDetector::create(Size size, const PlaneDetectorOptions& options,
                                            const KernelSet& kernels) {
  PlaneDetector made;
  made.options_ = options;
  made.options_.ransac = for_frame(options.ransac, size, options.frame);
  made.options_.hough = for_frame(options.hough, size, options.frame);
  made.options_.frame.kernels = kernels.depth;
  made.options_.ransac.kernels = kernels.plane_search;
  made.options_.hough.kernels = kernels.depth;
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

Result<Done> PlaneDetector::detect(const DepthView& depth, DetectedPlanes& result) {
  if (!depth.valid()) return refused(Status::invalid_image);
  if (result.labels.size() != depth.raw.size())
    result.labels = Image<std::uint16_t>::for_overwrite(depth.raw.size());
  result.planes.resize(options_.frame.max_planes);
  const bool ransac = options_.method == PlaneMethod::ransac;
  const PlaneSearch search = ransac ? plane_search(*ransac_) : plane_search(*hough_);
  const Status status = frame_->run(depth, search, result.labels.view(), result.planes, result.found);
  if (status != Status::ok) return refused(status);
  if (ransac) result.found.seed = options_.ransac.seed;
  result.planes.resize(result.found.planes);
  return Done{};
}

Result<DetectedPlanes> PlaneDetector::detect(const DepthView& depth) {
  DetectedPlanes result;
  if (auto done = detect(depth, result); !done) return done.failure();
  return result;
}

Result<DetectedPlanes> detect_planes(const DepthView& depth, const PlaneDetectorOptions& options,
                                     const KernelSet& kernels) {
  auto detector = PlaneDetector::create(depth.raw.size(), options, kernels);
  if (!detector) return detector.failure();
  return detector->detect(depth);
}

}  // namespace straightedge
