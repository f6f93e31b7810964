// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "io/plane_scene.hpp"
#include "straightedge/host/line_geometry.hpp"

namespace straightedge::io {

/// How one looks at an upright scene from far away: pixels are right and down, depth grows towards the eye.
struct ParallelView {
  Vector3 right, up, to_eye;

  /// The eye stands in the direction `turn` (from x to y) and `tilt` (above level).
  static ParallelView from(double turn_rad, double tilt_rad) noexcept;
  Point2 on_paper(const Vector3& p) const noexcept { return {dot(right, p), dot(up, p)}; }
};

/// The pieces from back to front: piece i hides behind piece j when i lies beyond the plane of j, or j on
/// this side of the plane of i, and their boxes on the paper meet. Of the pieces that nothing waiting lies
/// behind, the farthest is next; where pieces hide one another in a circle, the farthest of all. What
/// sticks out of a plane by less than 3 cm or 4 % is passed over unless the opposite order has nothing that
/// sticks out. O(n²) for n pieces, each of which stands for at
/// most 16 of its vertices.
std::vector<std::size_t> paint_order(const PlaneScene& scene, const ParallelView& view);

}  // namespace straightedge::io
