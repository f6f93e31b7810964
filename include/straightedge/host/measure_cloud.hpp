// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/result.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge {

/// How dense and how noisy a cloud is, so that thresholds need not be guessed.
struct CloudScale {
  double noise_m = 0;    ///< standard deviation of points from the surface they lie on
  double spacing_m = 0;  ///< between neighbouring points
  bool picture = false;  ///< the points of a pinhole camera's depth picture, z forward; see step 5
};

/// 1. Every n-th point that is a reading, 1000 of them at most.
/// 2. Of each its 24 nearest (octree.hpp), and the plane through these by least squares.
/// 3. Noise: the median of the planes' residuals, each freed of the three numbers that the fit took. Where
/// the
///    surface bends or ends within the neighbours, the residual is larger; in most clouds that is the smaller
///    part.
/// 4. Spacing: the median distance to the last of the 24, as if they covered a disc evenly.
/// 5. A picture has rows and columns and z > 0 in every reading, and x/z grows with the column and y/z with the
///    row as straight lines do, to less than a pixel (root mean square).
///
/// Zeros where there is nothing to measure: fewer than 25 readings, or equal ones. bad_content: a view that
/// makes no sense, or more than 2^30 points. Time as building the octree; 40 bytes a point.
Result<CloudScale> measure_cloud(const PointsView& points);

}  // namespace straightedge
