// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// How long planes of depth frames take, beside what is aimed at:
//   bench_targets [RUNS, default 21]
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
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/ransac_planes.hpp"
#include "thread_time.hpp"

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
  const auto kernels = kernels_from_environment();
  if (!kernels) fail(kernels.failure().sentence);
  const RansacOptions options{.kernels = kernels->ransac};
  std::vector<std::byte> memory(RansacPlanes::workspace_bytes(pixels, options));
  RansacPlanes ransac;
  if (RansacPlanes::prepare(ransac, pixels, options, memory) != Status::ok) fail("RANSAC cannot be prepared");
  std::vector<FoundPlane> plane(1);
  return median_ms(frames, runs, [&](std::size_t i) {
    if (ransac.run(frames[i].depth(), plane, {}).found.planes != 1) fail("no plane");
  });
}

PlaneDetector make_detector(const Frames& frames, PlaneMethod method) {
  PlaneDetectorOptions options;
  options.method = method;
  auto made = PlaneDetector::create(frames.front().raw.size(), options);
  if (!made) fail(made.failure().sentence);
  return std::move(*made);
}

DetectedPlanes detect(PlaneDetector& detector, const bench::FixtureFrame& frame) {
  auto found = detector.detect(frame.depth());
  if (!found) fail(found.failure().sentence);
  if (found->planes.empty()) fail("no plane");
  return std::move(*found);
}

double all_planes_ms(const Frames& frames, int runs, PlaneMethod method) {
  PlaneDetector detector = make_detector(frames, method);
  return median_ms(frames, runs, [&](std::size_t i) { detect(detector, frames[i]); });
}

/// Each run makes a new map, so that frames meet new places and known ones as on a drive.
double register_ms(const Frames& frames, int runs, PlaneMapBuilder& builder) {
  PlaneDetector detector = make_detector(frames, PlaneMethod::ransac);
  std::vector<DetectedPlanes> found;
  for (const auto& frame : frames) found.push_back(detect(detector, frame));
  return median_ms(frames, runs, [&](std::size_t i) {
    if (i == 0) builder = PlaneMapBuilder();
    const auto added =
        builder.add(frames[i].depth(), found[i].labels, found[i].planes, frames[i].world_from_camera);
    if (!added) fail(added.failure().sentence);
  });
}

/// What the detector works in, the labels, and the leaves that a frame adds to the map, in 10^6 bytes.
double memory_mb(const Frames& frames, const PlaneMapBuilder& builder) {
  constexpr std::size_t leaf_bytes = 170;
  const std::size_t ransac = make_detector(frames, PlaneMethod::ransac).workspace_bytes();
  const std::size_t hough = make_detector(frames, PlaneMethod::hough).workspace_bytes();
  const Size size = frames.front().raw.size();
  const std::size_t labels = 2 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  const std::size_t leaves = builder.leaves().size() * leaf_bytes / frames.size();
  return 1e-6 * static_cast<double>(std::max(ransac, hough) + labels + leaves);
}

/// One number for each row of the table.
struct Figures {
  double first, ransac, hough, registered, memory;
};

Figures measure(const Frames& frames, int runs) {
  PlaneMapBuilder builder;
  Figures f{};
  f.first = first_plane_ms(frames, runs);
  f.ransac = all_planes_ms(frames, runs, PlaneMethod::ransac);
  f.hough = all_planes_ms(frames, runs, PlaneMethod::hough);
  f.registered = register_ms(frames, runs, builder);
  f.memory = memory_mb(frames, builder);
  return f;
}

void print_row(const char* what, double room, double office, double bar, const char* unit, double thesis) {
  const double slower = std::max(room, office);
  const char* verdict = slower <= bar ? "met" : "missed";
  std::printf("%-34s %7.3g %7.3g %5.3g %s  ", what, room, office, bar, unit);
  if (thesis > 0) {
    std::printf("%-6s %7.0f ms %7.0f times\n", verdict, thesis, thesis / slower);
  } else {
    std::printf("%s\n", verdict);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 21;
  if (runs < 1 || argc > 2) {
    std::fprintf(stderr, "bench_targets [RUNS]: how often each frame is measured, 1 and up\n");
    return 2;
  }
  const Figures room = measure(bench::room_frames(), runs);
  const Figures office = measure(bench::office_frames(), runs);
  std::printf("%-34s %7s %7s %8s  %-6s %10s %13s\n", "a frame of 640 x 480", "room", "office", "bar", "",
              "thesis", "faster by");
  print_row("RANSAC, first plane", room.first, office.first, 0.15, "ms", ransac_thesis_ms);
  print_row("RANSAC, all planes and labels", room.ransac, office.ransac, 3, "ms", ransac_thesis_ms);
  print_row("Hough patches, all and labels", room.hough, office.hough, 4, "ms", hough_thesis_ms);
  print_row("registering into the plane map", room.registered, office.registered, 5, "ms", 0);
  print_row("memory of detector, labels, map", room.memory, office.memory, 16, "MB", 0);
}
