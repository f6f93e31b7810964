// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_view.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge {

/// A plane that a search proposes; which pixels are its own is settled afterwards.
struct ProposedPlane {
  InverseDepthFit fit;
  double score = 0;              ///< as FoundPlane::score
  double confidence = 0;         ///< as FoundPlane::confidence
  std::uint32_t iterations = 0;  ///< as FoundPlane::iterations
};

/// The method: looks at the readings (inverse depth above 0) whose label is 0, or at all of them when `labels`
/// has no data, and writes planes, strongest first; returns how many. RANSAC (ransac_search.hpp) and the Hough
/// transform (hough_plane_patches.hpp) are two of them.
struct PlaneSearch {
  void* user = nullptr;
  std::uint32_t (*run)(void* user, ImageView<const float> inverse_depth,
                       ImageView<const std::uint16_t> labels, const PinholeCamera& camera,
                       std::span<ProposedPlane> out) noexcept = nullptr;
};

}  // namespace straightedge
