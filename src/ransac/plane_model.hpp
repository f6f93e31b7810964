// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/readings.hpp"
#include "straightedge/plane_fit.hpp"

namespace straightedge::ransac {

/// Sums for a refit of a plane, in the coordinates of the readings.
struct ModelSums {
  InverseDepthMoments inverse;
  PlaneMoments space;

  double count() const noexcept { return inverse.n + space.count; }
  void add(const Reading& r, bool in_space) noexcept {
    if (in_space) {
      space.add({r.x, r.y, r.z}, 9 * r.w * r.w);
    } else {
      inverse.add(r.x, r.y, r.z);
    }
  }
};

/// The plane through three readings. False: two are equal, or all on a line.
bool plane_through(const Reading& a, const Reading& b, const Reading& c, bool in_space,
                   LinearPlane& plane) noexcept;

/// Least squares: in inverse depth, or orthogonal. False: the readings make no plane.
bool fit_model(const ModelSums& sums, const Readings& readings, LinearPlane& plane) noexcept;

/// The same with covariance, in the frame of the input.
bool fit_found(const ModelSums& sums, const Readings& readings, PlaneFit& fit) noexcept;

/// That of the sums in inverse depth.
bool fit_rays(const InverseDepthMoments& sums, const Readings& readings, PlaneFit& fit) noexcept;

/// The coefficients of a plane of the input's frame.
LinearPlane to_linear(const Plane& plane, const Readings& readings) noexcept;

}  // namespace straightedge::ransac
