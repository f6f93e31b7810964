// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_plane_patches.hpp"

namespace straightedge::hough {

/// What one run is about: its input's camera and noise, and what `prepare` was told.
struct PatchScene {
  Size size;
  PinholeCamera camera;
  PlaneGate gate;
  HoughPatchOptions options;
  double cell_size_rad = 0;

  /// Standard deviation of a reading's 1/z.
  double sigma(double q) const noexcept {
    return gate.fixed_m > 0 ? gate.fixed_m / gate.sigmas * q * q : gate.inverse_sigma;
  }
};

/// Cuts the picture into patches: the largest squares first; a square that is not planar is cut into four.
/// Returns how many were written.
std::size_t make_patches(const PatchScene& scene, std::span<const std::span<InverseDepthMoments>> levels,
                         std::span<HoughPatch> patches) noexcept;

}  // namespace straightedge::hough
