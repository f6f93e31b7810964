// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A row for each way to find planes by the Hough transform, on a real depth frame and on a rendered one:
//   bench_hough_planes --benchmark_filter=patches
// patches: the search on the picture of inverse depth; standard and randomized: the same readings as a cloud.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/hough_planes.hpp"
#include "straightedge/random.hpp"

namespace {

using namespace straightedge;

[[noreturn]] void fail(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  std::exit(70);
}

void require(Status status) {
  if (status != Status::ok) fail(to_string(status));
}

struct Frame {
  std::string name;
  PinholeCamera camera;
  Image<float> inverse_depth;
  std::vector<float> x, y, z;

  void add_points() {
    for (std::int32_t row = 0; row < inverse_depth.height(); ++row) {
      for (std::int32_t column = 0; column < inverse_depth.width(); ++column) {
        const auto q = static_cast<double>(inverse_depth.at(column, row));
        if (!(q > 0)) continue;
        const Vector3 p = (1 / q) * camera.ray(column, row);
        x.push_back(static_cast<float>(p.x));
        y.push_back(static_cast<float>(p.y));
        z.push_back(static_cast<float>(p.z));
      }
    }
  }
  PointsView points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

Frame office() {
  const std::filesystem::path folder = std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth" / "mrpt_office";
  const auto camera = read_camera(folder / "camera.json");
  if (!camera) fail(camera.failure().sentence);
  const auto raw = read_depth_frame(folder / "depth.png", *camera);
  if (!raw) fail(raw.failure().sentence);
  Frame frame{"/office/640x480", camera->pinhole, Image<float>(raw->size()), {}, {}, {}};
  require(
      inverse_depth_image({*raw, camera->metres_per_unit(), camera->pinhole}, frame.inverse_depth.view()));
  frame.add_points();
  return frame;
}

/// The inside of a room with a crate, noise as a Kinect's.
Frame room(Size size) {
  const double scale = size.width / 640.0;
  Frame frame{"/room/" + std::to_string(size.width) + "x" + std::to_string(size.height),
              {525 * scale, 525 * scale, (size.width - 1) / 2.0, (size.height - 1) / 2.0},
              Image<float>(size, 0.0F),
              {},
              {},
              {}};
  const Plane sides[] = {{normalized({0.3, 0.05, 1}), 3.2},
                         {normalized({1, 0, -0.2}), 1.6},
                         {normalized({-1, 0, 0.3}), 2.1},
                         {normalized({0, 1, 0.1}), 1.1},
                         {normalized({0, -1, 0.05}), 1.4}};
  const Plane crate{normalized({-0.5, 0.1, 0.9}), 1.5};
  Pcg32 random(1);
  for (std::int32_t row = 0; row < size.height; ++row) {
    for (std::int32_t column = 0; column < size.width; ++column) {
      const Vector3 ray = frame.camera.ray(column, row);
      double q = 0;
      for (const Plane& side : sides) {
        const double here = dot(side.normal, ray) / side.distance;
        q = here > q ? here : q;
      }
      const bool on_crate = row * 2 > size.height && column * 3 > size.width && column * 2 < size.width;
      if (on_crate) q = dot(crate.normal, ray) / crate.distance;
      const double noise = (random.below(2001) / 1000.0 - 1) * 2.4e-3;
      frame.inverse_depth.at(column, row) = static_cast<float>(q + noise);
    }
  }
  frame.add_points();
  return frame;
}

void run_patches(benchmark::State& state, const Frame& frame) {
  const HoughPatchOptions options{.kernels = best_kernels().depth};
  std::vector<std::byte> memory(HoughPatchSearch::workspace_bytes(frame.inverse_depth.size(), options));
  std::vector<ProposedPlane> candidates(64);
  HoughPatchSearch search;
  require(HoughPatchSearch::prepare(search, frame.inverse_depth.size(), options, memory));
  HoughPatchResult result;
  for (auto _ : state) {
    result = search.run(frame.inverse_depth, frame.camera, {}, candidates);
    benchmark::ClobberMemory();
  }
  require(result.status);
  if (result.candidates == 0) fail("no plane found");
  state.counters["planes"] = result.candidates;
  state.counters["bytes"] = static_cast<double>(memory.size());
}

void run_cloud(benchmark::State& state, const Frame& frame, HoughPlaneVoting voting) {
  HoughPlaneOptions options;
  options.voting = voting;
  options.gate = {};
  options.min_points = static_cast<std::uint32_t>(frame.x.size() / 50);
  std::vector<std::byte> memory(HoughPlanes::workspace_bytes(frame.x.size(), options));
  std::vector<std::uint16_t> labels(frame.x.size());
  std::vector<FoundPlane> planes(64);
  PlanesFound found;
  HoughPlanes search;
  require(HoughPlanes::prepare(search, frame.x.size(), options, memory));
  for (auto _ : state) {
    require(search.run(frame.points(), labels, planes, found));
    benchmark::ClobberMemory();
  }
  if (found.planes == 0) fail("no plane found");
  state.counters["planes"] = found.planes;
  state.counters["bytes"] = static_cast<double>(memory.size());
}

void add_rows(const std::shared_ptr<const Frame>& frame) {
  const auto add = [&](const char* stage, auto run) {
    benchmark::RegisterBenchmark((stage + frame->name).c_str(), [frame, run](benchmark::State& state) {
      run(state, *frame);
    })->Unit(benchmark::kMillisecond);
  };
  add("patches", [](benchmark::State& state, const Frame& f) { run_patches(state, f); });
  add("standard",
      [](benchmark::State& state, const Frame& f) { run_cloud(state, f, HoughPlaneVoting::standard); });
  add("randomized",
      [](benchmark::State& state, const Frame& f) { run_cloud(state, f, HoughPlaneVoting::randomized); });
}

}  // namespace

int main(int argc, char** argv) {
  add_rows(std::make_shared<const Frame>(room({320, 240})));
  add_rows(std::make_shared<const Frame>(room({640, 480})));
  add_rows(std::make_shared<const Frame>(office()));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
