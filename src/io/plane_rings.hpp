// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "straightedge/host/line_geometry.hpp"
#include "straightedge/vector3.hpp"

/// Closed borders in the plane; the last point is not the first again.
namespace straightedge::io {

using Ring = std::vector<Point2>;

/// Positive when it runs counter-clockwise.
double signed_area(const Ring& ring);

/// Of the area within; of the points when there is no area.
Point2 centroid(const Ring& ring);

/// Whether a walk from the point to infinity crosses the borders an odd number of times.
bool inside(Point2 point, const std::vector<Ring>& rings);

/// A point within the rings (outer border first) for a label: far from the borders, yet near the centroid.
/// Found on a grid that is refined twice; the centroid when no place of the grid is within.
Point2 label_place(const std::vector<Ring>& rings);

/// Sides of the smallest rectangle round the points, turned by whole degrees; the longer one first.
Point2 smallest_rectangle(const std::vector<Ring>& rings);

/// Two directions on the plane, right-handed with its normal: the first one is level when z is up and the
/// plane is not.
struct PlaneBasis {
  Vector3 u, v;
  explicit PlaneBasis(const Vector3& normal);
  Point2 flat(const Vector3& p) const noexcept { return {dot(u, p), dot(v, p)}; }
};

}  // namespace straightedge::io
