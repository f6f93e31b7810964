// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "straightedge/host/laser_scan.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

enum class ScanLineMethod : std::uint8_t {
  split_and_merge,  ///< along the order of the beams; the fastest
  ransac,           ///< two points by chance make a line, the one with most points near it is taken
  hough,            ///< the points as a picture, HoughLines (hough_lines.hpp), refit to the points
};

struct ScanLineOptions {
  ScanLineMethod method = ScanLineMethod::split_and_merge;
  double range_sigma_m = 0.02;       ///< noise of a range, (0, 1]
  double bearing_sigma_rad = 0.002;  ///< noise of a beam's direction, [0, 0.1]
  double split_distance_m = 0.07;    ///< points farther from a line than this are not of it, (0, 1]
  double max_gap_m = 0.35;           ///< a hole this wide between neighbours ends a line, (0, 100]
  double min_length_m = 0.25;        ///< shorter pieces are no lines, (0, 100]
  std::uint32_t min_points = 5;      ///< pieces of fewer points are no lines, >= 3
  double angle_floor_rad = 0.005;    ///< error that no number of points averages away, [0, 0.1]
  double offset_floor_m = 0.01;      ///< the same for the offset, [0, 1]
  std::uint64_t seed = 1;            ///< RANSAC and Hough
};

bool valid(const ScanLineOptions& options) noexcept;

/// A straight piece of a scan, in the robot's frame. The line passes through the centroid at right angles to
/// the normal, which points to the laser: the open floor is on its side. About the centroid, errors of angle
/// and offset are independent.
struct ScanLine {
  double theta_rad = 0;  ///< of the normal, (−pi, pi]
  double normal_x = 1, normal_y = 0;
  double centroid_x_m = 0, centroid_y_m = 0;
  double var_theta = 0;       ///< radians², with the floor
  double var_offset = 0;      ///< m², with the floor
  double residual_m = 0;      ///< root mean square distance of its points
  double x0_m = 0, y0_m = 0;  ///< the ends, on the line; the floor is on the left of the way from 0 to 1
  double x1_m = 0, y1_m = 0;
  std::uint32_t first_beam = 0;  ///< at end 0; in a circle it may be the greater number
  std::uint32_t last_beam = 0;   ///< at end 1
  std::uint32_t points = 0;
};

/// What became of the readings and of the pieces of a scan.
struct ScanLineCounts {
  std::uint32_t beams = 0;
  std::uint32_t no_reading = 0;    ///< NaN, infinite, 0, negative
  std::uint32_t beyond_range = 0;  ///< at max_range_m or beyond
  std::uint32_t too_few = 0;       ///< pieces dropped: fewer points than min_points
  std::uint32_t too_short = 0;     ///< pieces dropped: shorter than min_length_m
  std::uint32_t merged = 0;        ///< pieces that became part of their neighbour
  std::uint32_t lines = 0;
};

/// A reading as a point in the robot's frame.
struct ScanPoint {
  double x_m = 0, y_m = 0;
  double range_m = 0;
  std::uint32_t beam = 0;
};

/// The straight pieces of a laser scan, each with its covariance.
///
///  1. Readings become points; those that are none go. Points are in the order of growing bearing; a circle
///     is cut at its widest gap, so that no wall is torn at the seam.
///  2. Runs: neighbours farther apart than max_gap_m (and than a wall seen at a small angle would put them)
///     belong to different things.
///  3. Split: the point farthest from the line through a run's ends splits it, if it is farther than
///     split_distance_m; and so on for both halves.
///  4. Merge: neighbours of one run become one piece if all their points fit one line and the chi-square test
///     (fit/line_fit) finds no difference.
///  5. Fit: weighted total least squares; a point's weight is 1 / its variance along the normal,
///     sigma_r² (n·u)² + (r sigma_phi)² (n·v)², u along the beam, v across it. Two rounds.
///  6. Ends: the outermost points, put on the line. Short pieces go. Floors are added.
/// RANSAC and Hough replace steps 2 to 4: they find lines wherever their points are in the order, and cut
/// them at gaps; they are here for comparison.
///
/// A reading's noise is taken as independent of its neighbours'; the floors stand for what is not.
///
/// D. H. Douglas, T. K. Peucker, 1973, doi:10.3138/FM57-6770-U75U-7727.
/// V. Nguyen, S. Gächter, A. Martinelli, N. Tomatis, R. Siegwart, "A comparison of line extraction algorithms
/// using 2D range data for indoor mobile robotics", Autonomous Robots 23, 2007,
/// doi:10.1007/s10514-007-9034-y. S. T. Pfister, S. I. Roumeliotis, J. W. Burdick, ICRA 2003,
/// doi:10.1109/ROBOT.2003.1241767.
///
/// Time: n log n for n beams (RANSAC: draws times n; Hough: about a million cells). Memory is kept from scan
/// to scan; scans may change in size. A scan that cannot be used (step 0 or not finite, a laser pose that is
/// not) gives no points; one without readings gives no lines.
class ScanLineFinder {
 public:
  /// bad_option: a number out of its range.
  static Result<ScanLineFinder> create(const ScanLineOptions& options = {});

  ScanLineFinder(ScanLineFinder&&) noexcept;
  ScanLineFinder& operator=(ScanLineFinder&&) noexcept;
  ScanLineFinder(const ScanLineFinder&);
  ScanLineFinder& operator=(const ScanLineFinder&);
  ~ScanLineFinder();

  /// False: the scan cannot be used. The lists below are of the last run.
  bool run(const LaserScan& scan);

  const std::vector<ScanLine>& lines() const noexcept { return lines_; }     ///< by first_beam's bearing
  const std::vector<ScanPoint>& points() const noexcept { return points_; }  ///< by bearing
  const ScanLineCounts& counts() const noexcept { return counts_; }

 private:
  struct Memory;
  explicit ScanLineFinder(const ScanLineOptions& options);

  ScanLineOptions options_;
  std::vector<ScanPoint> points_;
  std::vector<ScanLine> lines_;
  ScanLineCounts counts_;
  std::unique_ptr<Memory> memory_;  // scratch
};

}  // namespace straightedge
