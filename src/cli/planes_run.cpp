// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_run.hpp"

#include <chrono>
#include <optional>
#include <utility>

#include "cli/picture_input.hpp"
#include "cli/planes_first.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/depth_file.hpp"

namespace straightedge::cli {
namespace {

struct Detectors {
  std::vector<PlaneDetector> all;
  std::vector<FirstPlane> first;  ///< empty for a single method
};

std::string text_of(Size size) {
  return io::to_text(size.width) + " x " + io::to_text(size.height) + " pixels";
}

/// What the sequence itself says against a frame.
std::optional<Failure> known_problem(const SequenceFrame& frame) {
  if (frame.problem.empty()) return {};
  const bool missing = frame.problem == frame.file.string() + ": is missing";
  return Failure{missing ? Problem::cannot_read : Problem::bad_content, frame.problem};
}

/// One of each method, for the size of the first good frame.
Result<Detectors> make_detectors(const PlanesArguments& arguments, const SequenceFrame& frame, Size size) {
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  Detectors detectors;
  const std::vector<PlaneMethod> methods = arguments.method_list();
  for (const PlaneMethod method : methods) {
    const PlaneDetectorOptions options = arguments.detector_options(method);
    const std::size_t bytes = FramePlanes::workspace_bytes(size, options.frame);
    if (auto fits = check_memory(frame.file, bytes); !fits) return fits.failure();
    auto made = PlaneDetector::create(size, options, *kernels);
    if (!made) return Failure{made.failure().problem, frame.file.string() + ": " + made.failure().sentence};
    detectors.all.push_back(std::move(*made));
    if (methods.size() == 1) continue;
    auto first = FirstPlane::create(size, options);
    if (!first)
      return Failure{first.failure().problem, frame.file.string() + ": " + first.failure().sentence};
    detectors.first.push_back(std::move(*first));
  }
  return detectors;
}

Result<std::vector<MethodFrame>> look_at(Detectors& detectors, std::vector<MethodRun>& methods,
                                         const DepthView& depth, const Pose& pose) {
  std::vector<MethodFrame> seen;
  for (std::size_t m = 0; m < detectors.all.size(); ++m) {
    const auto before = std::chrono::steady_clock::now();
    auto detected = detectors.all[m].detect(depth);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - before;
    if (!detected) return detected.failure();
    auto registered = methods[m].builder.add(depth, detected->labels, detected->planes, pose);
    if (!registered) return registered.failure();
    const auto pixels =
        static_cast<std::size_t>(depth.raw.width) * static_cast<std::size_t>(depth.raw.height);
    seen.push_back({.labels = runs_of({detected->labels.view().data, pixels}),
                    .planes = std::move(detected->planes),
                    .found = detected->found,
                    .registered = std::move(*registered),
                    .ids = {},
                    .first_ms = detectors.first.empty() ? 0 : detectors.first[m].time(depth),
                    .detection_ms = time.count()});
  }
  return seen;
}

/// All that is kept while frames come in.
struct Walk {
  const PlanesArguments& arguments;
  PlanesRun run;
  Detectors detectors;
  std::uint64_t planes = 0;

  Result<Done> take(const SequenceFrame& frame) {
    if (const auto problem = known_problem(frame)) return *problem;
    const auto depth = read_depth_frame(frame.file, run.camera);
    if (!depth) return depth.failure();
    if (run.frames.empty()) {
      auto made = make_detectors(arguments, frame, depth->size());
      if (!made) return made.failure();
      detectors = std::move(*made);
      run.size = depth->size();
    } else if (depth->size() != run.size) {
      return Failure{Problem::bad_content, frame.file.string() + ": is " + text_of(depth->size()) +
                                               ", and the frames before are " + text_of(run.size)};
    }
    const DepthView view{*depth, run.camera.metres_per_unit(), run.camera.pinhole};
    auto seen = look_at(detectors, run.methods, view, *frame.pose);
    if (!seen) return Failure{seen.failure().problem, frame.file.string() + ": " + seen.failure().sentence};
    run.frames.push_back(frame);
    run.readings += seen->front().found.readings;
    planes += seen->front().planes.size();
    for (std::size_t m = 0; m < seen->size(); ++m) run.methods[m].frames.push_back(std::move((*seen)[m]));
    return Done{};
  }
};

}  // namespace

Result<Done> read_map(MethodRun& method) {
  auto reading = method.builder.build();
  if (!reading) return reading.failure();
  method.reading = std::move(*reading);
  for (MapPlane& plane : method.reading.map.planes) plane.source = name_of(method.method);
  for (MethodFrame& frame : method.frames) {
    for (const PlaneAnchors& anchors : frame.registered.planes)
      frame.ids.push_back(method.reading.plane_id(anchors));
  }
  return Done{};
}

Result<PlanesRun> run_planes(const PlanesArguments& arguments, const DepthSequence& sequence,
                             Progress& progress) {
  Walk walk{arguments, {}, {}};
  walk.run.camera = sequence.camera;
  for (const PlaneMethod method : arguments.method_list())
    walk.run.methods.push_back({method, PlaneMapBuilder(arguments.map_options()), {}, {}});
  const std::string of = " of " + io::to_text(sequence.frames.size()) + ", ";
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    progress.tell(arguments.input + ": frame " + io::to_text(i + 1) + of + io::to_text(walk.planes) +
                  " planes so far");
    const auto taken = walk.take(sequence.frames[i]);
    if (taken) continue;
    const Failure& failure = taken.failure();
    if (arguments.strict || sequence.frames.size() == 1 || failure.problem == Problem::bad_option)
      return failure;
    progress.say("straightedge: " + one_line(failure.sentence) + "; the frame is skipped");
    walk.run.skipped.push_back({sequence.frames[i].name, failure.sentence});
  }
  if (walk.run.frames.empty())
    return Failure{Problem::bad_content, arguments.input + ": none of its " +
                                             io::to_text(sequence.frames.size()) + " frames can be used"};
  for (MethodRun& method : walk.run.methods) {
    if (auto read = read_map(method); !read)
      return Failure{read.failure().problem, arguments.input + ": " + read.failure().sentence};
  }
  return std::move(walk.run);
}

}  // namespace straightedge::cli
