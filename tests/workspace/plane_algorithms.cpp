// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "algorithms.hpp"
#include "inputs.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/found_planes.hpp"
#include "straightedge/frame_planes.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/hough_planes.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_search.hpp"

namespace workspace {
namespace {

Size size() {
  return inverse_depth().size();
}

const PinholeCamera& camera() {
  return depth_frame().camera;
}

void say(CallerMemory& memory, std::span<const FoundPlane> planes) {
  memory.say({static_cast<double>(planes.size())});
  for (const FoundPlane& found : planes) {
    const Plane& p = found.fit.plane;
    memory.say({p.normal.x, p.normal.y, p.normal.z, p.distance, found.fit.rms, found.fit.covariance[0],
                found.inliers * 1.0, found.iterations * 1.0, found.score});
  }
}

void say(CallerMemory& memory, std::span<const ProposedPlane> planes) {
  for (const ProposedPlane& found : planes) {
    const InverseDepthFit& fit = found.fit;
    memory.say({fit.plane.a, fit.plane.b, fit.plane.c, fit.n, fit.rms, fit.covariance[0], found.score,
                found.readings * 1.0, found.column0 * 1.0, found.row1 * 1.0});
  }
}

/// The walls of the box, as if found.
std::span<FoundPlane> walls(CallerMemory& memory) {
  const auto truth = support::box_planes();
  const auto planes = memory.list<FoundPlane>(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    planes[k] = {};
    planes[k].fit.plane = canonical(truth[k]);
  }
  return planes;
}

void say(CallerMemory& memory, std::span<const std::uint16_t> labels) {
  for (const std::uint16_t label : labels) memory.say({label * 1.0});
}

Status run_inverse_depth(CallerMemory& memory) {
  return inverse_depth_image({memory.input(depth_frame().raw), 0.001, camera()},
                             memory.output<float>(size()));
}

Status run_cells(CallerMemory& memory) {
  DepthCells cells;
  Arena needed = Arena::measure();
  cells.take(needed, size());
  Arena arena(memory.workspace(needed.used()));
  cells.take(arena, size());
  if (arena.failed()) return Status::workspace_too_small;
  cells.build(memory.input(inverse_depth()));
  for (int level = 0; level < DepthCells::levels; ++level) {
    for (std::size_t i = 0; i < DepthCells::cell_count(cells.size(level)); ++i) {
      const InverseDepthMoments m = cells.moments(level, i);
      memory.say({m.n, m.u, m.vv, m.uq, m.qq});
    }
  }
  return Status::ok;
}

Status run_label(CallerMemory& memory) {
  const PointsView points = memory.input(cloud());
  const auto planes = walls(memory);
  const auto labels = memory.list<std::uint16_t>(points.count);
  std::uint32_t labelled = 0;
  const Status status = label_nearest(points, planes, {}, labels, labelled);
  memory.say({labelled * 1.0});
  say(memory, labels);
  return status;
}

Status run_refit(CallerMemory& memory) {
  const PointsView points = memory.input(cloud());
  const auto planes = walls(memory);
  const auto labels = memory.list<std::uint16_t>(points.count);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Vector3 p = points.at(i);
    const auto nearer = [&](const FoundPlane& a, const FoundPlane& b) {
      return std::abs(a.fit.plane.signed_distance(p)) < std::abs(b.fit.plane.signed_distance(p));
    };
    labels[i] = static_cast<std::uint16_t>(std::min_element(planes.begin(), planes.end(), nearer) -
                                           planes.begin() + 1);
  }
  const Status status = refit_labelled(points, labels, {}, planes);
  say(memory, planes);
  return status;
}

Status run_ransac_search(CallerMemory& memory) {
  const RansacSearchOptions options;
  RansacSearch search;
  const Status prepared = RansacSearch::prepare(
      search, size(), options, memory.workspace(RansacSearch::workspace_bytes(size(), options)));
  const auto candidates = memory.list<ProposedPlane>(64);
  Image<std::uint16_t> mask(size());
  mask.at(40, 40) = 1;
  const auto result =
      search.run(FrameCells(memory.input(inverse_depth())).view(), memory.input(mask), candidates);
  memory.say({result.candidates * 1.0, result.readings * 1.0, result.explained * 1.0, result.noise,
              result.draws * 1.0});
  say(memory, candidates.first(result.candidates));
  return whole(prepared, result.status);
}

RansacOptions ransac_options() {
  RansacOptions options;
  options.max_planes = 5;
  options.subset = 512;
  options.split = true;
  return options;
}

Status run_ransac_frame(CallerMemory& memory) {
  const auto readings = static_cast<std::size_t>(size().width * size().height);
  RansacPlanes ransac;
  const Status prepared =
      RansacPlanes::prepare(ransac, readings, ransac_options(),
                            memory.workspace(RansacPlanes::workspace_bytes(readings, ransac_options())));
  const auto planes = memory.list<FoundPlane>(20);
  const auto result =
      ransac.run(memory.input(inverse_depth()), camera(), planes, memory.output<std::uint16_t>(size()));
  say(memory, planes.first(result.found.planes));
  return whole(prepared, result.status);
}

Status run_ransac_cloud(CallerMemory& memory) {
  const PointsView points = memory.input(cloud());
  RansacPlanes ransac;
  const Status prepared =
      RansacPlanes::prepare(ransac, points.count, ransac_options(),
                            memory.workspace(RansacPlanes::workspace_bytes(points.count, ransac_options())));
  const auto planes = memory.list<FoundPlane>(20);
  const auto labels = memory.list<std::uint16_t>(points.count);
  const auto result = ransac.run(points, planes, labels);
  say(memory, planes.first(result.found.planes));
  if (result.status == Status::ok) say(memory, labels);
  return whole(prepared, result.status);
}

template <HoughPlaneVoting voting>
Status run_hough_cloud(CallerMemory& memory) {
  HoughPlaneOptions options;
  options.voting = voting;
  options.accumulator = {HoughCells::ball, 20, 64};
  options.min_points = 200;
  options.gate.fixed_m = 0.03;
  options.every = 24;
  options.max_draws = 20000;
  const PointsView points = memory.input(cloud());
  HoughPlanes search;
  const Status prepared = HoughPlanes::prepare(
      search, points.count, options, memory.workspace(HoughPlanes::workspace_bytes(points.count, options)));
  const auto planes = memory.list<FoundPlane>(20);
  const auto labels = memory.list<std::uint16_t>(points.count);
  PlanesFound found;
  const Status ran = search.run(points, labels, planes, found);
  say(memory, planes.first(found.planes));
  if (ran == Status::ok) say(memory, labels);
  return whole(prepared, ran);
}

Status run_hough_patches(CallerMemory& memory) {
  HoughPatchOptions options;
  options.accumulator = {HoughCells::array, 20, 48};
  HoughPatchSearch search;
  const Status prepared = HoughPatchSearch::prepare(
      search, size(), options, memory.workspace(HoughPatchSearch::workspace_bytes(size(), options)));
  const auto candidates = memory.list<ProposedPlane>(20);
  Image<std::uint16_t> mask(size());
  mask.at(40, 40) = 1;
  const auto result = search.run(memory.input(inverse_depth()), camera(), memory.input(mask), candidates);
  memory.say({result.candidates * 1.0, result.readings * 1.0, result.patches * 1.0, result.votes * 1.0});
  say(memory, candidates.first(result.candidates));
  return whole(prepared, result.status);
}

Status run_plane_peaks(CallerMemory& memory) {
  const HoughAccumulatorOptions options{HoughCells::ball, 12, 20};
  HoughAccumulator accumulator;
  Arena needed = Arena::measure();
  accumulator.take(needed, options);
  Arena arena(memory.workspace(needed.used()));
  accumulator.take(arena, options);
  if (arena.failed()) return Status::workspace_too_small;
  accumulator.fill(options.cells);
  accumulator.clear(0.1);
  for (int i = 0; i < 300; ++i) accumulator.vote(i % 40, 0.005 * i, 64);
  const auto smooth = memory.list<std::uint32_t>(HoughAccumulator::cell_count(options));
  const auto peaks = memory.list<HoughPlanePeak>(200);
  const Status low_pass = low_pass_votes(accumulator, smooth);
  std::uint32_t count = 0;
  const Status found = find_plane_peaks(accumulator, smooth, 200, peaks, count);
  memory.say({count * 1.0});
  for (const HoughPlanePeak& peak : peaks.first(count)) {
    memory.say({peak.direction * 1.0, peak.distance * 1.0, peak.votes * 1.0});
  }
  return low_pass == Status::ok ? found : low_pass;
}

/// Proposes the walls of the box.
Status propose_walls(void*, ImageView<const float>, const DepthCells&, ImageView<const std::uint16_t>,
                     const PinholeCamera& seen_by, std::span<ProposedPlane> out,
                     std::uint32_t& count) noexcept {
  count = 0;
  for (const Plane& wall : support::box_planes()) {
    out[count] = {};
    out[count++].fit.plane = to_inverse_depth(wall, seen_by);
  }
  return Status::ok;
}

Status run_frame_planes(CallerMemory& memory) {
  FramePlanesOptions options;
  options.max_planes = 16;
  FramePlanes frame;
  const Status prepared =
      frame.prepare(size(), options, memory.workspace(FramePlanes::workspace_bytes(size(), options)));
  const auto planes = memory.list<FoundPlane>(16);
  PlanesFound found;
  const Status ran = frame.run({memory.input(depth_frame().raw), 0.001, camera()}, {nullptr, propose_walls},
                               memory.output<std::uint16_t>(size()), planes, found);
  say(memory, planes.first(found.planes));
  return whole(prepared, ran);
}

constexpr Algorithm algorithms[] = {
    {"inverse depth", run_inverse_depth},
    {"depth cells", run_cells},
    {"label nearest", run_label},
    {"refit labelled", run_refit},
    {"ransac search", run_ransac_search},
    {"ransac planes of a frame", run_ransac_frame},
    {"ransac planes of a cloud", run_ransac_cloud},
    {"hough planes standard", run_hough_cloud<HoughPlaneVoting::standard>},
    {"hough planes randomized", run_hough_cloud<HoughPlaneVoting::randomized>},
    {"hough patches", run_hough_patches},
    {"hough plane peaks", run_plane_peaks},
    {"frame planes", run_frame_planes},
};

}  // namespace

std::span<const Algorithm> plane_algorithms() {
  return algorithms;
}

}  // namespace workspace
