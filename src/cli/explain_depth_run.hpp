// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "straightedge/host/frame_cells.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/ransac_planes.hpp"

namespace straightedge::cli {

/// Plain RANSAC in one square of the frame, watched.
struct WatchedWindow {
  std::int32_t x = 0, y = 0, side_u = 0, side_v = 0;  ///< pixels of the frame
  std::vector<RansacEvent> events;                    ///< every hypothesis; triples are pixels of the window
  std::uint32_t subset = 0;                           ///< readings on which they are scored
  double share = 0;                                   ///< of the window's readings on its largest plane
  InverseDepthPlane refitted;                         ///< what became of the best; frame's pixels
};

/// What the search by RANSAC left behind.
struct RansacStage {
  RansacSearchResult result;
  std::vector<ProposedPlane> candidates;
  std::optional<WatchedWindow> window;
};

/// A plane that grew from a peak of the accumulator. The k-th of them is what HoughPatch::candidate calls
/// k + 1.
struct GrownPlane {
  HoughPlaneEvent peak;
  Plane plane;
  std::uint16_t number = 0;  ///< among the candidates, from 1; 0: others explain its readings as well
};

/// What the search by the Hough transform left behind: its first voting.
struct HoughStage {
  std::unique_ptr<std::byte[]> memory;
  HoughPatchSearch search;
  HoughPatchResult result;
  std::vector<ProposedPlane> candidates;
  std::uint32_t peaks = 0;         ///< looked at
  std::vector<GrownPlane> planes;  ///< in the order of their peaks
};

/// What every stage left behind.
struct ExplainDepthRun {
  DepthView depth;
  PlaneDetectorOptions options;
  Image<float> inverse_depth;
  std::optional<FrameCells> cells;

  RansacStage ransac;                         ///< empty when the method is the other one
  HoughStage hough;                           ///< empty when the method is the other one
  std::vector<InverseDepthPlane> candidates;  ///< of the search on the whole frame, strongest first
  Image<std::uint16_t> nearest;  ///< 1 + the candidate that is nearest to a pixel within the gate

  std::optional<PlaneDetector> detector;
  DetectedPlanes found;

  /// Of this frame alone; nothing is dropped for being uncertain. Planes have the ids of the frame's, the
  /// lowest where several are one.
  PlaneMap map;
};

/// Runs all stages. Fails as PlaneDetector and PlaneMapBuilder do.
Result<ExplainDepthRun> run_depth_stages(const DepthView& depth, const PlaneDetectorOptions& options);

// Steps of it.
void search_by_ransac(ExplainDepthRun& run);
void search_by_hough(ExplainDepthRun& run);
/// Needs `found`.
void watch_window(ExplainDepthRun& run);

}  // namespace straightedge::cli
