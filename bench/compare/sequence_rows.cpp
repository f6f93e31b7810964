// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "alternation.hpp"
#include "fixture_frames.hpp"
#include "rows.hpp"
#include "straightedge/host/parallel.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"

namespace compare {
namespace {

using namespace straightedge;

template <class T>
T taken(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.failure().sentence.c_str());
    std::exit(70);
  }
  return std::move(*result);
}

/// Depth frames into one map: frames are shared out over threads, each with a detector and leaves of its own.
class SequenceMap {
 public:
  SequenceMap(const std::vector<bench::FixtureFrame>& frames, unsigned threads)
      : frames_(frames), pool_(threads) {
    while (detectors_.size() < pool_.threads())
      detectors_.push_back(taken(PlaneDetector::create(frames[0].raw.size(), {})));
  }
  void run() {
    std::vector<PlaneMapBuilder> builders(pool_.threads());
    pool_.for_each_index(frames_.size(), [&](std::size_t i, unsigned thread) {
      const bench::FixtureFrame& frame = frames_[i];
      const DetectedPlanes found = taken(detectors_[thread].detect(frame.depth()));
      taken(builders[thread].add(frame.depth(), found.labels.view(), found.planes, frame.world_from_camera));
    });
    for (std::size_t t = 1; t < builders.size(); ++t) taken(builders[0].merge(builders[t]));
    map_ = taken(builders[0].build()).map;
  }
  const PlaneMap& map() const { return map_; }

 private:
  const std::vector<bench::FixtureFrame>& frames_;
  ThreadPool pool_;
  std::vector<PlaneDetector> detectors_;
  PlaneMap map_;
};

}  // namespace

void print_threaded_sequence_rows(int rounds) {
  std::vector<bench::FixtureFrame> frames = bench::room_frames();
  for (bench::FixtureFrame& frame : bench::room_frames()) frames.push_back(std::move(frame));
  SequenceMap all(frames, 0), one(frames, 1);
  print_row({"plane map of a sequence", std::to_string(frames.size()) + " frames, room",
             std::string(best_kernels().name), [&] { all.run(); }, [&] { one.run(); },
             [&] { return !all.map().planes.empty() && all.map() == one.map(); }, "ours, one thread",
             [&] { return "the same " + std::to_string(all.map().planes.size()) + " planes"; }},
            rounds, Clock::wall);
}

}  // namespace compare
