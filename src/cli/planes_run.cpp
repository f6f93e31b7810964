// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_run.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "cli/planes_worker.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/parallel.hpp"

namespace straightedge::cli {
namespace {

using Seen = Result<std::vector<MethodFrame>>;

/// Takes what was seen in frames, in any order, and does with it what one thread would have done in the order
/// of frames.
class InOrder {
 public:
  InOrder(const PlanesArguments& arguments, const DepthSequence& sequence, PlanesRun& run, Progress& progress)
      : arguments_(arguments), frames_(sequence.frames), run_(run), progress_(progress) {
    waiting_.resize(frames_.size());
  }

  void hand_in(std::size_t frame, Seen seen) {
    const std::lock_guard lock(mutex_);
    waiting_[frame] = std::move(seen);
    for (; next_ < frames_.size() && waiting_[next_] && !failure_; ++next_) {
      take(frames_[next_], *waiting_[next_]);
      waiting_[next_].reset();
      tell_progress();
    }
  }

  /// Whether a failure ends everything; work on later frames is of no use then.
  bool failed() const noexcept { return failed_; }
  const std::optional<Failure>& failure() const noexcept { return failure_; }

  void tell_progress() {
    progress_.tell(arguments_.input + ": frame " + io::to_text(std::min(next_ + 1, frames_.size())) + " of " +
                   io::to_text(frames_.size()) + ", " + io::to_text(planes_) + " planes so far");
  }

 private:
  void take(const SequenceFrame& frame, Seen& seen) {
    if (!seen) return refuse(frame, seen.failure());
    run_.frames.push_back(frame);
    run_.readings += seen->front().found.readings;
    planes_ += seen->front().planes.size();
    for (std::size_t m = 0; m < seen->size(); ++m) run_.methods[m].frames.push_back(std::move((*seen)[m]));
  }

  void refuse(const SequenceFrame& frame, const Failure& failure) {
    if (arguments_.strict || frames_.size() == 1 || failure.problem == Problem::bad_option) {
      failure_ = failure;
      failed_ = true;
      return;
    }
    progress_.say("straightedge: " + one_line(failure.sentence) + "; the frame is skipped");
    run_.skipped.push_back({frame.name, failure.sentence});
  }

  const PlanesArguments& arguments_;
  const std::vector<SequenceFrame>& frames_;
  PlanesRun& run_;
  Progress& progress_;
  std::mutex mutex_;
  std::vector<std::optional<Seen>> waiting_;  // one a frame, empty before and after
  std::size_t next_ = 0;
  std::uint64_t planes_ = 0;
  std::optional<Failure> failure_;
  std::atomic<bool> failed_ = false;
};

/// All frames through workers, one a thread. The first good frame says what size all have; until it is there
/// one thread works alone.
std::vector<PlanesWorker> work_on(const PlanesArguments& arguments, const DepthSequence& sequence,
                                  const KernelSet& kernels, PlanesRun& run, InOrder& in_order) {
  std::vector<PlanesWorker> workers;
  workers.emplace_back(arguments, run.camera, kernels);
  std::size_t first = 0;
  for (; first < sequence.frames.size() && run.frames.empty() && !in_order.failed(); ++first)
    in_order.hand_in(first, workers[0].take(sequence.frames[first], run.size));
  if (in_order.failed()) return workers;
  ThreadPool pool(arguments.thread_count(sequence.frames.size() - first));
  while (workers.size() < pool.threads()) workers.emplace_back(arguments, run.camera, kernels);
  pool.for_each_index(sequence.frames.size() - first, [&](std::size_t index, unsigned thread) {
    if (in_order.failed()) return;
    const std::size_t frame = first + index;
    in_order.hand_in(frame, workers[thread].take(sequence.frames[frame], run.size));
  });
  return workers;
}

Result<Done> join_maps(std::vector<PlanesWorker>& workers, PlanesRun& run) {
  for (std::size_t m = 0; m < run.methods.size(); ++m) {
    PlaneMapBuilder& builder = run.methods[m].builder;
    builder = std::move(workers[0].builder(m));
    for (std::size_t w = 1; w < workers.size(); ++w) {
      if (auto merged = builder.merge(workers[w].builder(m)); !merged) return merged;
    }
  }
  return Done{};
}

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
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  PlanesRun run;
  run.camera = sequence.camera;
  for (const PlaneMethod method : arguments.method_list())
    run.methods.push_back({method, PlaneMapBuilder(arguments.map_options(), *kernels), {}, {}});
  InOrder in_order(arguments, sequence, run, progress);
  in_order.tell_progress();
  std::vector<PlanesWorker> workers = work_on(arguments, sequence, *kernels, run, in_order);
  if (in_order.failure()) return *in_order.failure();
  if (run.frames.empty())
    return Failure{Problem::bad_content, arguments.input + ": none of its " +
                                             io::to_text(sequence.frames.size()) + " frames can be used"};
  const auto in_input = [&](const Failure& failure) {
    return Failure{failure.problem, arguments.input + ": " + failure.sentence};
  };
  if (auto joined = join_maps(workers, run); !joined) return in_input(joined.failure());
  for (MethodRun& method : run.methods) {
    if (auto read = read_map(method); !read) return in_input(read.failure());
  }
  return run;
}

}  // namespace straightedge::cli
