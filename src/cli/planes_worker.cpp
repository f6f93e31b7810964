// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_worker.hpp"

#include <chrono>
#include <optional>
#include <utility>

#include "cli/picture_input.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/depth_file.hpp"

namespace straightedge::cli {
namespace {

std::string text_of(Size size) {
  return io::to_text(size.width) + " x " + io::to_text(size.height) + " pixels";
}

/// What the sequence itself says against a frame.
std::optional<Failure> known_problem(const SequenceFrame& frame) {
  if (frame.problem.empty()) return {};
  const bool missing = frame.problem == frame.file.string() + ": is missing";
  return Failure{missing ? Problem::cannot_read : Problem::bad_content, frame.problem};
}

Failure of_frame(const SequenceFrame& frame, const Failure& failure) {
  return {failure.problem, frame.file.string() + ": " + failure.sentence};
}

}  // namespace

PlanesWorker::PlanesWorker(const PlanesArguments& arguments, const DepthCamera& camera,
                           const KernelSet& kernels)
    : arguments_(&arguments),
      kernels_(&kernels),
      camera_(&camera),
      builders_(arguments.method_list().size(), PlaneMapBuilder(arguments.map_options(), kernels)) {}

Result<Done> PlanesWorker::make_detectors(const SequenceFrame& frame, Size size) {
  size_ = {};
  detectors_.clear();
  first_.clear();
  const std::vector<PlaneMethod> methods = arguments_->method_list();
  for (const PlaneMethod method : methods) {
    const PlaneDetectorOptions options = arguments_->detector_options(method, size);
    const std::size_t bytes = FramePlanes::workspace_bytes(size, options.frame);
    if (auto fits = check_memory(frame.file, bytes); !fits) return fits.failure();
    auto made = PlaneDetector::create(size, options, *kernels_);
    if (!made) return of_frame(frame, made.failure());
    detectors_.push_back(std::move(*made));
    if (methods.size() == 1) continue;
    auto first = FirstPlane::create(size, options, *kernels_);
    if (!first) return of_frame(frame, first.failure());
    first_.push_back(std::move(*first));
  }
  size_ = size;
  return Done{};
}

Result<std::vector<MethodFrame>> PlanesWorker::look_at(const DepthView& depth, const Pose& pose) {
  std::vector<MethodFrame> seen;
  for (std::size_t m = 0; m < detectors_.size(); ++m) {
    const auto before = std::chrono::steady_clock::now();
    auto done = detectors_[m].detect(depth, detected_);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - before;
    if (!done) return done.failure();
    auto registered = builders_[m].add(depth, detected_.labels, detected_.planes, pose);
    if (!registered) return registered.failure();
    const auto pixels =
        static_cast<std::size_t>(depth.raw.width) * static_cast<std::size_t>(depth.raw.height);
    seen.push_back({.labels = runs_of({detected_.labels.view().data, pixels}),
                    .planes = detected_.planes,
                    .found = detected_.found,
                    .registered = std::move(*registered),
                    .ids = {},
                    .first_ms = first_.empty() ? 0 : first_[m].time(depth),
                    .detection_ms = time.count()});
  }
  return seen;
}

Result<std::vector<MethodFrame>> PlanesWorker::take(const SequenceFrame& frame, Size& size) {
  if (const auto problem = known_problem(frame)) return *problem;
  const auto depth = read_depth_frame(frame.file, *camera_);
  if (!depth) return depth.failure();
  const bool first = size == Size{};
  if (!first && depth->size() != size)
    return Failure{Problem::bad_content, frame.file.string() + ": is " + text_of(depth->size()) +
                                             ", and the frames before are " + text_of(size)};
  if (depth->size() != size_) {
    if (auto made = make_detectors(frame, depth->size()); !made) return made.failure();
  }
  auto seen = look_at({*depth, camera_->metres_per_unit(), camera_->pinhole}, *frame.pose);
  if (!seen) return of_frame(frame, seen.failure());
  if (first) size = depth->size();
  return seen;
}

}  // namespace straightedge::cli
