// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// How long planes of depth frames take, beside what is aimed at, as a Markdown table:
//   bench_targets [RUNS, default 21 | --shape: rows without measuring]
// Processor time of one thread. A frame's time is the median of its runs, a folder's that of its frames; the
// slower folder decides. The two old times are those of the thesis that the library began with: RANSAC to the
// first plane of a frame, the 3D Hough transform to a plane.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "fixture_frames.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "thread_time.hpp"
#include "with_kernels.hpp"

namespace {

using namespace straightedge;

using Frames = std::vector<bench::FixtureFrame>;

constexpr double ransac_thesis_ms = 50, hough_thesis_ms = 170;

[[noreturn]] void fail(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  std::exit(70);
}

/// Frame i of a folder, through one job.
using Job = std::function<void(std::size_t)>;

double median_ms(const Frames& frames, int runs, const Job& job) {
  std::vector<std::vector<double>> times(frames.size());
  for (int run = 0; run < runs; ++run) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const double before = bench::thread_ms();
      job(i);
      times[i].push_back(bench::thread_ms() - before);
    }
  }
  std::vector<double> medians;
  for (const auto& of_frame : times) medians.push_back(bench::median(of_frame));
  return bench::median(medians);
}

double first_plane_ms(const Frames& frames, int runs) {
  const Size size = frames.front().raw.size();
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  bench::FirstPlane first(pixels, {}, best_kernels());
  if (!first.prepared()) fail("RANSAC cannot be prepared");
  return median_ms(frames, runs, [&](std::size_t i) {
    if (first.run(frames[i].depth()).found.planes != 1) fail("no plane");
  });
}

/// Large planes have this share of the pixels and more, the others this many and more.
constexpr double large_share = 0.05;
constexpr std::uint32_t small_pixels = 1000;

PlaneDetector make_detector(const Frames& frames, PlaneMethod method, bool large) {
  PlaneDetectorOptions options;
  options.method = method;
  options.frame.min_pixels = small_pixels;
  const Size size = frames.front().raw.size();
  auto made = PlaneDetector::create(size, large ? for_large_planes(options, size, large_share) : options);
  if (!made) fail(made.failure().sentence);
  return std::move(*made);
}

void detect(PlaneDetector& detector, const bench::FixtureFrame& frame, DetectedPlanes& found) {
  if (auto done = detector.detect(frame.depth(), found); !done) fail(done.failure().sentence);
  if (found.planes.empty()) fail("no plane");
}

double all_planes_ms(const Frames& frames, int runs, PlaneMethod method, bool large) {
  PlaneDetector detector = make_detector(frames, method, large);
  DetectedPlanes found;
  return median_ms(frames, runs, [&](std::size_t i) { detect(detector, frames[i], found); });
}

/// Each run makes a new map, so that frames meet new places and known ones as on a drive.
double register_ms(const Frames& frames, int runs, PlaneMapBuilder& builder) {
  PlaneDetector detector = make_detector(frames, PlaneMethod::ransac, false);
  std::vector<DetectedPlanes> found(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) detect(detector, frames[i], found[i]);
  return median_ms(frames, runs, [&](std::size_t i) {
    if (i == 0) builder = PlaneMapBuilder();
    const auto added =
        builder.add(frames[i].depth(), found[i].labels, found[i].planes, frames[i].world_from_camera);
    if (!added) fail(added.failure().sentence);
  });
}

/// All frames from depth to a finished map, a frame's share.
double sequence_ms(const Frames& frames, int runs) {
  PlaneDetector detector = make_detector(frames, PlaneMethod::ransac, false);
  DetectedPlanes found;
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    const double before = bench::thread_ms();
    PlaneMapBuilder builder;
    for (const auto& frame : frames) {
      detect(detector, frame, found);
      const auto added = builder.add(frame.depth(), found.labels, found.planes, frame.world_from_camera);
      if (!added) fail(added.failure().sentence);
    }
    const auto reading = builder.build();
    if (!reading || reading->map.planes.empty()) fail("no map");
    times.push_back((bench::thread_ms() - before) / static_cast<double>(frames.size()));
  }
  return bench::median(times);
}

/// What the detector works in, the labels, and the leaves that a frame adds to the map, in 10^6 bytes.
double memory_mb(const Frames& frames, const PlaneMapBuilder& builder) {
  constexpr std::size_t leaf_bytes = 170;
  const std::size_t ransac = make_detector(frames, PlaneMethod::ransac, false).workspace_bytes();
  const std::size_t hough = make_detector(frames, PlaneMethod::hough, false).workspace_bytes();
  const Size size = frames.front().raw.size();
  const std::size_t labels = 2 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  const std::size_t leaves = builder.leaves().size() * leaf_bytes / frames.size();
  return 1e-6 * static_cast<double>(std::max(ransac, hough) + labels + leaves);
}

/// A row of the table.
struct Target {
  const char* what;
  const char* unit;
  double bar, thesis;  ///< thesis: 0 where it did not measure
  std::function<double(const Frames&)> measure;
};

std::vector<Target> targets(int runs) {
  const auto all = [runs](PlaneMethod method, bool large) {
    return [=](const Frames& f) { return all_planes_ms(f, runs, method, large); };
  };
  const auto registered = [runs](const Frames& f) {
    PlaneMapBuilder builder;
    return register_ms(f, runs, builder);
  };
  const auto memory = [](const Frames& f) {
    PlaneMapBuilder builder;
    register_ms(f, 1, builder);
    return memory_mb(f, builder);
  };
  return {
      {"first plane, RANSAC", "ms", 0.15, ransac_thesis_ms,
       [=](const Frames& f) { return first_plane_ms(f, runs); }},
      {"planes of 5 %, labels, RANSAC", "ms", 0.6, ransac_thesis_ms, all(PlaneMethod::ransac, true)},
      {"planes of 1000 pixels, labels, RANSAC", "ms", 2.4, ransac_thesis_ms, all(PlaneMethod::ransac, false)},
      {"planes of 5 %, labels, Hough", "ms", 0.8, hough_thesis_ms, all(PlaneMethod::hough, true)},
      {"planes of 1000 pixels, labels, Hough", "ms", 4, hough_thesis_ms, all(PlaneMethod::hough, false)},
      {"registering into the plane map", "ms", 5, 0, registered},
      {"sequence to plane map, a frame", "ms", 2, 0, [=](const Frames& f) { return sequence_ms(f, runs); }},
      {"memory of detector, labels, map", "MB", 16, 0, memory},
  };
}

void print_row(const Target& target, double room, double office) {
  const double slower = std::max(room, office);
  std::printf("| %s | %.2f | %.2f | %g %s | %s | ", target.what, room, office, target.bar, target.unit,
              slower <= target.bar ? "met" : "missed");
  if (target.thesis > 0) {
    std::printf("%.0f ms | %.0f |\n", target.thesis, slower > 0 ? target.thesis / slower : 0);
  } else {
    std::printf("– | – |\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool shape = argc > 1 && std::string(argv[1]) == "--shape";
  const int runs = argc > 1 && !shape ? std::atoi(argv[1]) : 21;
  if (runs < 1 || argc > 2) {
    std::fprintf(stderr, "bench_targets [RUNS | --shape]: how often each frame is measured, 1 and up\n");
    return 2;
  }
  const Frames room = bench::room_frames(), office = bench::office_frames();
  std::printf("| a frame of 640x480 | room | office | bar | | thesis | times faster |\n");
  std::printf("| --- | ---: | ---: | --- | :---: | ---: | ---: |\n");
  for (const Target& target : targets(runs))
    print_row(target, shape ? 0 : target.measure(room), shape ? 0 : target.measure(office));
}
