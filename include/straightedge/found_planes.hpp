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
/// For the Kinect's noise model, z of the points is the depth seen by a sensor at the origin; a point with
/// z <= 0 then has no plane. `labels` has one entry a point. Returns how many points got a label.
Status label_nearest(const PointsView& points, std::span<const FoundPlane> planes, const PlaneGate& gate,
                     std::span<std::uint16_t> labels, std::uint32_t& labelled) noexcept;

/// Fits every plane anew to the points that carry its label, weights 1/sigma² along the normal, and counts
/// them. A plane with fewer than three points keeps its fit.
Status refit_labelled(const PointsView& points, std::span<const std::uint16_t> labels, const PlaneGate& gate,
                      std::span<FoundPlane> planes) noexcept;

}  // namespace straightedge
