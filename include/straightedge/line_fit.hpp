// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/status.hpp"

namespace straightedge {

/// Weighted sums over points, all that a line fit needs. Sums of two sets of points add up to the sums
/// of both together, so fits can be merged exactly, without the points.
///
/// Coordinates are relative to an origin that the caller keeps in mind; choose it near the points
/// (the first of them will do), or digits are lost.
struct LineMoments {
  double weight = 0;
  double x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0;
  double count = 0;  ///< points, whatever their weight

  constexpr void add(double px, double py, double w = 1) noexcept {
    weight += w;
    x += w * px;
    y += w * py;
    xx += w * px * px;
    xy += w * px * py;
    yy += w * py * py;
    count += 1;
  }
  constexpr void add(const LineMoments& other) noexcept {
    weight += other.weight;
    x += other.x;
    y += other.y;
    xx += other.xx;
    xy += other.xy;
    yy += other.yy;
    count += other.count;
  }
  /// The same points seen from an origin that lies at (ox, oy) of the present one.
  constexpr LineMoments seen_from(double ox, double oy) const noexcept {
    LineMoments moved = *this;
    moved.x = x - weight * ox;
    moved.y = y - weight * oy;
    moved.xx = xx - 2 * ox * x + weight * ox * ox;
    moved.xy = xy - ox * y - oy * x + weight * ox * oy;
    moved.yy = yy - 2 * oy * y + weight * oy * oy;
    return moved;
  }
};

/// A line with its uncertainty. The line passes through the centroid at right angles to
/// (cos theta, sin theta); about the centroid, errors of angle and of offset are independent.
struct LineFit {
  double theta = 0;     ///< direction of the normal, radians, in (−pi/2, pi/2]
  double normal_x = 1;  ///< cos theta
  double normal_y = 0;  ///< sin theta
  double centroid_x = 0;
  double centroid_y = 0;
  double var_theta = 0;   ///< radians²
  double var_offset = 0;  ///< squared units of the coordinates
  double residual = 0;    ///< root mean square distance of the points from the line

  constexpr double distance(double px, double py) const noexcept {
    return (px - centroid_x) * normal_x + (py - centroid_y) * normal_y;
  }
};

/// Errors that no number of points averages away: they are common to all points of a line (staircases
/// of slanted walls, pixels that a wall's edge was rounded to). Measured against exact floor plans,
/// see docs/line-map.md.
struct LineFloor {
  double offset = 0.19;       ///< standard deviation, pixels
  double angle_length = 0.2;  ///< standard deviation of the angle times the length, pixels
};

/// Weighted total least squares.
///
/// 1. Centroid m = sum(w p) / sum(w).
/// 2. Scatter about it: a = sum(w (x−mx)²), b = sum(w (x−mx)(y−my)), c = sum(w (y−my)²).
/// 3. The normal is the direction of least scatter: theta = 1/2 atan2(−2b, c − a).
/// 4. Covariance, for weights that are 1/sigma² of each point along the normal:
///    var theta = 1 / (scatter along the line), var offset = 1 / sum(w).
///
/// S. T. Pfister, S. I. Roumeliotis, J. W. Burdick, "Weighted line fitting algorithms for mobile robot
/// map building and efficient data representation", ICRA 2003, doi:10.1109/ROBOT.2003.1241767.
/// K. O. Arras, R. Siegwart, "Feature extraction and scene interpretation for map-based navigation and
/// map building", SPIE 3210, 1997, doi:10.1117/12.299565.
///
/// invalid_option: fewer than two points, all points in one place, sums that are not numbers.
Status fit_line(const LineMoments& moments, LineFit& fit) noexcept;

/// Adds the floor for a line of this length to the variances.
void add_floor(LineFit& fit, double length, const LineFloor& floor) noexcept;

/// Chi-square distance (2 degrees of freedom) between two lines that may be the same one: 5.99 is
/// exceeded by one true pair in twenty, 9.21 by one in a hundred. The test is made midway between the two
/// centroids, where neither line's lever is long. Normals may point to opposite sides.
double line_chi_square(const LineFit& a, const LineFit& b) noexcept;

}  // namespace straightedge
