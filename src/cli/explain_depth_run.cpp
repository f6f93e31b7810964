// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_depth_run.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/inverse_depth.hpp"

namespace straightedge::cli {
namespace {

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
void rename_planes(const PlaneMapReading& reading, const RegisteredFrame& registered, PlaneMap& map) {
  auto unnamed = static_cast<std::uint32_t>(registered.planes.size());
  for (MapPlane& plane : map.planes) {
    const auto known =
        std::find_if(registered.planes.begin(), registered.planes.end(),
                     [&](const PlaneAnchors& anchors) { return reading.plane_id(anchors) == plane.id; });
    plane.id = known == registered.planes.end()
                   ? ++unnamed
                   : static_cast<std::uint32_t>(known - registered.planes.begin()) + 1;
  }
}

/// All planes are to be seen, also those that a map would rather have from more frames.
PlaneMapOptions lenient_options(const PlaneGate& gate) {
  PlaneMapOptions options;
  options.gate = gate;
  options.min_points = 1;
  options.max_tilt = 2;
  options.max_residual = 1e6;
  options.min_area = 0;
  return options;
}

Result<Done> make_map(ExplainDepthRun& run) {
  PlaneMapBuilder builder(lenient_options(run.options.frame.gate));
  const auto registered = builder.add(run.depth, run.found.labels, run.found.planes, Pose{});
  if (!registered) return registered.failure();
  auto reading = builder.build();
  if (!reading) return reading.failure();
  run.map = reading->map;
  rename_planes(*reading, *registered, run.map);
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
  run.cells.emplace(run.inverse_depth);
  if (options.method == PlaneMethod::ransac) search_by_ransac(run);
  if (options.method == PlaneMethod::hough) search_by_hough(run);
  run.nearest = nearest_candidates(run);
  if (options.method == PlaneMethod::ransac) watch_window(run);
  if (auto made = make_map(run); !made) return made.failure();
  return run;
}

}  // namespace straightedge::cli
