// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "hough/planes/patch_cells.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/hough_plane_patch.hpp"
#include "straightedge/image.hpp"
#include "straightedge/plane_gate.hpp"

namespace straightedge::hough {

/// What one run is about: its input's camera and noise, and what `prepare` was told.
struct PatchScene {
  Size size;
  PinholeCamera camera;
  PlaneGate gate;
  HoughPatchOptions options;
  double cell_size_rad = 0;  ///< of the accumulator
  double step_m = 0;         ///< of its distances

  /// In the camera's frame. Distance 0: through the camera, or no plane at all.
  Plane space(const InverseDepthPlane& plane) const noexcept {
    const Vector3 m{plane.a * camera.fx, plane.b * camera.fy,
                    plane.c + plane.a * camera.cx + plane.b * camera.cy};
    const double per_distance = length(m);
    if (!(per_distance > 0) || !(per_distance < 1e100)) return {};
    return {(1 / per_distance) * m, 1 / per_distance};
  }
};

inline double readings_of(const HoughPatch& patch) noexcept {
  return static_cast<double>(patch.cell.n);
}

/// Step 2 of hough_plane_patches.hpp. Returns how many patches were written.
std::size_t make_patches(const PatchScene& scene, const PatchLevels& levels,
                         std::span<HoughPatch> patches) noexcept;

}  // namespace straightedge::hough
