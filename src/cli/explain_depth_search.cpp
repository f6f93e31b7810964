// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "cli/explain_depth_run.hpp"

namespace straightedge::cli {
namespace {

constexpr std::int32_t window_side = 208;  // pixels: the search's largest windows have 13 cells of 16
constexpr std::int32_t window_step = 104;
constexpr std::uint32_t window_subset = 256;
constexpr double wanted_share = 0.4;

struct PeakWatcher {
  HoughStage& stage;
  HoughPlaneEvent peak;
};

bool note_peaks_and_planes(void* user, const HoughPlaneEvent& event) {
  PeakWatcher& watcher = *static_cast<PeakWatcher*>(user);
  if (event.step == HoughPlaneStep::peak) {
    watcher.peak = event;
    ++watcher.stage.peaks;
  }
  if (event.step == HoughPlaneStep::plane) watcher.stage.planes.push_back({watcher.peak, event.plane, 0});
  return true;
}

bool are_equal(const InverseDepthPlane& a, const InverseDepthPlane& b) {
  const double off = std::abs(a.a - b.a) + std::abs(a.b - b.b) + std::abs(a.c - b.c);
  return off <= 1e-9 * (std::abs(a.a) + std::abs(a.b) + std::abs(a.c));
}

bool note_hypothesis(void* user, const RansacEvent& event) {
  static_cast<WatchedWindow*>(user)->events.push_back(event);
  return true;
}

/// Share of the window's readings that the plane with most of them has; 0 for too few readings.
double largest_share(const ExplainDepthRun& run, const WatchedWindow& window) {
  std::vector<std::uint32_t> counts(run.found.planes.size() + 1);
  std::uint32_t readings = 0;
  for (std::int32_t y = window.y; y < window.y + window.side_v; ++y) {
    for (std::int32_t x = window.x; x < window.x + window.side_u; ++x) {
      if (run.inverse_depth.at(x, y) <= 0) continue;
      ++readings;
      ++counts[run.found.labels.at(x, y)];
    }
  }
  const auto pixels = static_cast<std::uint32_t>(window.side_u * window.side_v);
  if (run.found.planes.empty() || readings < window_subset || readings < pixels / 2) return 0;
  return static_cast<double>(*std::max_element(counts.begin() + 1, counts.end())) / readings;
}

/// Where it is neither trivial nor hopeless: not quite half of the readings lie on one plane.
std::optional<WatchedWindow> window_to_watch(const ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  std::optional<WatchedWindow> best;
  for (std::int32_t y = 0; y < size.height; y += window_step) {
    for (std::int32_t x = 0; x < size.width; x += window_step) {
      WatchedWindow window;
      window.side_u = std::min(window_side, size.width);
      window.side_v = std::min(window_side, size.height);
      window.x = std::min(x, size.width - window.side_u);
      window.y = std::min(y, size.height - window.side_v);
      window.share = largest_share(run, window);
      if (window.share == 0) continue;
      if (!best || std::abs(window.share - wanted_share) < std::abs(best->share - wanted_share))
        best = window;
    }
  }
  return best;
}

}  // namespace

void search_by_ransac(ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  RansacSearchOptions options = run.options.ransac;
  options.gate = widened(run.options.frame);
  std::vector<std::byte> memory(RansacSearch::workspace_bytes(size, options));
  RansacSearch search;
  if (RansacSearch::prepare(search, size, options, memory) != Status::ok) return;
  RansacStage& stage = run.ransac;
  stage.candidates.resize(run.options.frame.max_planes);
  stage.result = search.run(run.cells->view(), {}, stage.candidates);
  stage.candidates.resize(stage.result.candidates);
  for (const ProposedPlane& candidate : stage.candidates) run.candidates.push_back(candidate.fit.plane);
}

void search_by_hough(ExplainDepthRun& run) {
  const Size size = run.depth.raw.size();
  HoughPatchOptions options = run.options.hough;
  options.rounds = 1;
  options.gate = widened(run.options.frame);
  HoughStage& stage = run.hough;
  const std::size_t bytes = HoughPatchSearch::workspace_bytes(size, options);
  stage.memory = std::make_unique<std::byte[]>(bytes);
  if (HoughPatchSearch::prepare(stage.search, size, options, {stage.memory.get(), bytes}) != Status::ok)
    return;
  stage.candidates.resize(run.options.frame.max_planes);
  PeakWatcher watcher{stage, {}};
  stage.result = stage.search.run(run.inverse_depth, run.depth.camera, {}, stage.candidates,
                                  {.event = note_peaks_and_planes, .user = &watcher});
  stage.candidates.resize(stage.result.candidates);
  for (const ProposedPlane& candidate : stage.candidates) run.candidates.push_back(candidate.fit.plane);
  for (GrownPlane& grown : stage.planes) {
    const InverseDepthPlane plane = to_inverse_depth(grown.plane, run.depth.camera);
    for (std::size_t k = 0; k < run.candidates.size(); ++k) {
      if (are_equal(run.candidates[k], plane)) grown.number = static_cast<std::uint16_t>(k + 1);
    }
  }
}

void watch_window(ExplainDepthRun& run) {
  auto window = window_to_watch(run);
  if (!window) return;
  // The textbook's search on a square of about the size of the real one's largest windows: that
  // one has no trace, and what happens in it is the same.
  RansacOptions options;
  options.gate = widened(run.options.frame);
  options.subset = window_subset;
  options.confidence = run.options.ransac.confidence;
  options.seed = run.options.ransac.seed;
  options.min_inliers = 16;
  options.trace = {.event = note_hypothesis, .user = &*window};
  const auto pixels = static_cast<std::size_t>(window->side_u * window->side_v);
  std::vector<std::byte> memory(RansacPlanes::workspace_bytes(pixels, options));
  RansacPlanes planes;
  if (RansacPlanes::prepare(planes, pixels, options, memory) != Status::ok) return;
  const ImageView<const float> whole = run.inverse_depth.view();
  const ImageView<const float> part{
      whole.row(window->y) + window->x, {window->side_u, window->side_v}, whole.stride};
  FoundPlane found;
  // Pixels of the window count from its corner.
  const PinholeCamera& whole_camera = run.depth.camera;
  const PinholeCamera camera{whole_camera.fx, whole_camera.fy, whole_camera.cx - window->x,
                             whole_camera.cy - window->y};
  const RansacPlanesResult result = planes.run(part, camera, {&found, 1}, {});
  window->subset = window_subset;
  if (result.found.planes == 0 || window->events.empty()) return;
  window->refitted = to_inverse_depth(found.fit.plane, whole_camera);
  run.ransac.window = std::move(window);
}

}  // namespace straightedge::cli
