// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/scan_lines.hpp"

#include <algorithm>
#include <cmath>

#include "localize/pieces.hpp"
#include "localize/scan_points.hpp"

namespace straightedge {

struct ScanLineFinder::Memory {
  localize::BeamTable beams;
  localize::StretchMemory stretches;
  localize::Pieces pieces;
};

namespace {

bool in_range(double value, double above, double most) {
  return value > above && value <= most;
}

bool not_negative(double value, double most) {
  return value >= 0 && value <= most;
}

double length_of(const ScanLine& line) {
  const double dx = line.x1_m - line.x0_m, dy = line.y1_m - line.y0_m;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

bool valid(const ScanLineOptions& o) noexcept {
  return in_range(o.range_sigma_m, 0, 1) && not_negative(o.bearing_sigma_rad, 0.1) &&
         in_range(o.split_distance_m, 0, 1) && in_range(o.max_gap_m, 0, 100) &&
         in_range(o.min_length_m, 0, 100) && o.min_points >= 3 && not_negative(o.angle_floor_rad, 0.1) &&
         not_negative(o.offset_floor_m, 1);
}

Result<ScanLineFinder> ScanLineFinder::create(const ScanLineOptions& options) {
  if (!valid(options))
    return Failure{Problem::bad_option, "an option of the scan's lines is not a number or out of its range"};
  return ScanLineFinder(options);
}

ScanLineFinder::ScanLineFinder(const ScanLineOptions& options)
    : options_(options), memory_(std::make_unique<Memory>()) {}
ScanLineFinder::ScanLineFinder(const ScanLineFinder& other)
    : options_(other.options_),
      points_(other.points_),
      lines_(other.lines_),
      counts_(other.counts_),
      memory_(std::make_unique<Memory>(*other.memory_)) {}
ScanLineFinder& ScanLineFinder::operator=(const ScanLineFinder& other) {
  return *this = ScanLineFinder(other);
}
ScanLineFinder::ScanLineFinder(ScanLineFinder&&) noexcept = default;
ScanLineFinder& ScanLineFinder::operator=(ScanLineFinder&&) noexcept = default;
ScanLineFinder::~ScanLineFinder() = default;

bool ScanLineFinder::run(const LaserScan& scan) {
  lines_.clear();
  localize::Pieces& pieces = memory_->pieces;
  pieces.clear();
  // Step 1.
  if (!localize::take_points(scan, memory_->beams, points_, counts_)) return false;
  const localize::Laser laser{scan.laser_in_robot.x_m, scan.laser_in_robot.y_m};
  const localize::PointRow row{points_, scan.angle_step_rad, laser, options_};
  // Steps 2 to 4.
  switch (options_.method) {
    case ScanLineMethod::split_and_merge:
      localize::split_and_merge(row, memory_->stretches, pieces, counts_);
      break;
    case ScanLineMethod::ransac:
      localize::ransac_pieces(row, pieces);
      break;
    case ScanLineMethod::hough:
      localize::hough_pieces(row, pieces);
      break;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // Step 5.
    LineFit fit;
    if (!localize::fit_points(points_, pieces[i], laser, options_, fit)) {
      ++counts_.too_short;
      continue;
    }
    // Step 6.
    const ScanLine line = localize::line_of(points_, pieces[i], laser, options_, fit);
    if (length_of(line) < options_.min_length_m) {
      ++counts_.too_short;
    } else {
      lines_.push_back(line);
    }
  }
  counts_.lines = static_cast<std::uint32_t>(lines_.size());
  return true;
}

}  // namespace straightedge
