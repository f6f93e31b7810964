// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/plane_fit.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// A plane that a detector found, in the frame of its input. In label images and arrays its readings
/// carry its index + 1; 0 is no plane.
struct FoundPlane {
  PlaneFit fit;
  std::uint32_t inliers = 0;     ///< readings with its label
  std::uint32_t iterations = 0;  ///< hypotheses tried (RANSAC), votes cast (Hough)
  double confidence = 0;         ///< RANSAC: probability that no better plane was missed; else 0
  double score = 0;              ///< RANSAC: MSAC score of the subset; Hough: votes of the peak
};

/// What a detector says about its whole run.
struct PlanesFound {
  std::uint32_t planes = 0;      ///< how many were written
  std::uint32_t readings = 0;    ///< valid pixels or points
  std::uint32_t labelled = 0;    ///< of these, how many carry a label
  std::uint32_t iterations = 0;  ///< all planes together
  std::uint64_t seed = 0;        ///< as used
};

/// Gives every point the label of its nearest plane within the gate, else 0; ties go to the lower index.
///
/// With gate.fixed_m, nearest is by distance in metres. Otherwise z is the depth that a sensor at the
/// origin measured, and nearest is by the difference of 1/z from the plane's along the point's ray: the
/// most likely plane. The gate then is sigmas · inverse_noise(1/z), which is threshold_m(z) to first order; points
/// with z <= 0 and planes through the origin get nothing. Points that are not finite have label 0.
///
/// `labels` has one entry a point, `labelled` says how many got a plane. Points times planes in time.
/// size_mismatch: `labels` is not as long as the points; too_large: more than 65535 planes.
Status label_nearest(const PointsView& points, std::span<const FoundPlane> planes, const PlaneGate& gate,
                     std::span<std::uint16_t> labels, std::uint32_t& labelled) noexcept;

/// Fits every plane anew to the points that carry its label, and counts them. Labels above the number of
/// planes are no plane.
///
/// With gate.fixed_m by fit_plane, the threshold taken as three standard deviations. Otherwise in 1/z over
/// the rays of the points (inverse_depth.hpp): an orthogonal fit, however weighted, is pulled aside by noise
/// along oblique rays. Planes whose points make no plane (fewer than three, on one line, for 1/z all seen
/// from edge-on) keep their fit.
Status refit_labelled(const PointsView& points, std::span<const std::uint16_t> labels, const PlaneGate& gate,
                      std::span<FoundPlane> planes) noexcept;

}  // namespace straightedge
