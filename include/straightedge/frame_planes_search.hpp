// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// A plane that a search proposes; which pixels are its own is settled afterwards.
struct ProposedPlane {
  InverseDepthFit fit = {};
  double score = 0;       ///< RANSAC: sum of 1 − (residual / gate)² over its readings; Hough: votes of
                          ///< the peak that led to it
  double confidence = 0;  ///< as FoundPlane::confidence
  std::uint32_t iterations = 0;  ///< of the whole search, as FoundPlane::iterations
  std::uint32_t readings = 0;    ///< it was fitted to. RANSAC: one a cell; Hough: all of its patches
  std::uint32_t patches = 0;     ///< Hough: squares that share it
  bool rough = false;            ///< RANSAC: residuals fill the gate: curved, bent, or two surfaces
  /// Where its readings are: pixels [column0, column1) x [row0, row1), the last of which may lie beyond the
  /// picture.
  std::int32_t column0 = 0, row0 = 0, column1 = 0, row1 = 0;
};

/// The method: looks at the readings (inverse depth above 0) whose label is 0, or at all of them when
/// `labels` has no data, and writes `count` planes, strongest first; output_full: there were more. `cells` are
/// of all readings, whatever their labels. RANSAC and the Hough transform are two of them: plane_search in
/// ransac_search.hpp and in hough_plane_patches.hpp.
struct PlaneSearch {
  void* user = nullptr;
  Status (*run)(void* user, ImageView<const float> inverse_depth, const DepthCells& cells,
                ImageView<const std::uint16_t> labels, const PinholeCamera& camera,
                std::span<ProposedPlane> out, std::uint32_t& count) noexcept = nullptr;
  /// How often to search, each time what is left over, unless FramePlanesOptions say so. One that finds all
  /// there is at once asks for 1.
  std::uint32_t rounds = 2;
};

}  // namespace straightedge
