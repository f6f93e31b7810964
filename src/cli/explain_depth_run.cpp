// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_depth_run.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/arena.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::cli {
namespace {

void build_cells(ExplainDepthRun& run) {
  Arena counted = Arena::measure();
  run.cells.take(counted, run.depth.raw.size());
  run.cells_memory = std::make_unique<std::byte[]>(counted.used());
  Arena arena({run.cells_memory.get(), counted.used()});
  run.cells.take(arena, run.depth.raw.size());
  run.cells.build(run.inverse_depth);
}

Image<std::uint16_t> nearest_candidates(const ExplainDepthRun& run) {
  const PlaneGate gate = widened(run.options.frame);
  Image<std::uint16_t> nearest(run.depth.raw.size());
  for (std::int32_t y = 0; y < nearest.height(); ++y) {
    for (std::int32_t x = 0; x < nearest.width(); ++x) {
      const auto q = static_cast<double>(run.inverse_depth.at(x, y));
      if (!(q > 0)) continue;
      double least = gate.sigmas * gate.inverse_noise(q);
      for (std::size_t k = 0; k < run.candidates.size(); ++k) {
        const double away = std::abs(run.candidates[k].at(x, y) - q);
        if (away > least) continue;
        least = away;
        nearest.at(x, y) = static_cast<std::uint16_t>(k + 1);
      }
    }
  }
  return nearest;
}

/// The map's planes get the ids of the frame's, so that colours and numbers are the same in all pictures.
void rename_planes(ExplainDepthRun& run, const RegisteredFrame& registered) {
  std::vector<std::uint32_t> names(run.map.map.planes.size());
  run.ids.assign(run.found.planes.size(), 0);
  auto next = static_cast<std::uint32_t>(run.found.planes.size());
  for (std::size_t k = 0; k < registered.planes.size(); ++k) {
    const std::uint32_t id = run.map.plane_id(registered.planes[k]);
    for (std::size_t m = 0; m < names.size() && id != 0; ++m) {
      if (run.map.map.planes[m].id != id) continue;
      if (names[m] == 0) names[m] = static_cast<std::uint32_t>(k + 1);
      run.ids[k] = names[m];
    }
  }
  for (std::size_t m = 0; m < names.size(); ++m) run.map.map.planes[m].id = names[m] != 0 ? names[m] : ++next;
}

Result<Done> make_map(ExplainDepthRun& run) {
  PlaneMapOptions options;
  options.gate = run.options.frame.gate;
  PlaneMapBuilder builder(options);
  const auto registered = builder.add(run.depth, run.found.labels, run.found.planes, Pose{});
  if (!registered) return registered.failure();
  auto reading = builder.build();
  if (!reading) return reading.failure();
  run.map = std::move(*reading);
  rename_planes(run, *registered);
  return Done{};
}

}  // namespace

Result<ExplainDepthRun> run_depth_stages(const DepthView& depth, const PlaneDetectorOptions& options) {
  ExplainDepthRun run;
  run.depth = depth;
  run.options = options;
  auto detector = PlaneDetector::create(depth.raw.size(), options);
  if (!detector) return detector.failure();
  run.detector = std::move(*detector);
  auto found = run.detector->detect(depth);
  if (!found) return found.failure();
  run.found = std::move(*found);
  run.inverse_depth = Image<float>(depth.raw.size());
  if (inverse_depth_image(depth, run.inverse_depth.view()) != Status::ok)
    return Failure{Problem::internal, "inverse depth of a frame that has planes"};
  build_cells(run);
  if (options.method == PlaneMethod::ransac) search_by_ransac(run);
  if (options.method == PlaneMethod::hough) search_by_hough(run);
  run.nearest = nearest_candidates(run);
  if (options.method == PlaneMethod::ransac) watch_window(run);
  if (auto made = make_map(run); !made) return made.failure();
  return run;
}

}  // namespace straightedge::cli
