// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/scan_points.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge::localize {
namespace {

constexpr double farthest_m = 1e5;  // a reading beyond it is no laser's
constexpr double spread = 3;        // spacings of the beams
constexpr std::size_t most_beams = std::size_t{1} << 22;

bool is_circle(const LaserScan& scan) {
  const double reach = static_cast<double>(scan.ranges_m.size()) * std::fabs(scan.angle_step_rad);
  return std::fabs(reach - 2 * pi) < 0.5 * std::fabs(scan.angle_step_rad);
}

bool usable_scan(const LaserScan& scan) {
  const double step = std::fabs(scan.angle_step_rad);
  if (!(step > 0 && step <= 2 * pi) || !(std::fabs(scan.first_angle_rad) <= 100)) return false;
  if (scan.ranges_m.size() > most_beams) return false;
  return usable(scan.laser_in_robot) && !std::isnan(scan.max_range_m) && std::isfinite(scan.time_s);
}

double squared_distance(const ScanPoint& a, const ScanPoint& b) {
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return dx * dx + dy * dy;
}

/// A circle has no first point: begin after the widest gap, so that no wall is torn.
void cut_at_widest_gap(std::vector<ScanPoint>& points) {
  std::size_t first = 0;
  double widest = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double gap = squared_distance(points[(i + points.size() - 1) % points.size()], points[i]);
    if (gap > widest) {
      widest = gap;
      first = i;
    }
  }
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
}

}  // namespace

void BeamTable::update(const LaserScan& scan) {
  const double turn = scan.laser_in_robot.heading_rad;
  if (directions_.size() == scan.ranges_m.size() && first_ == scan.first_angle_rad &&
      step_ == scan.angle_step_rad && turn_ == turn)
    return;
  first_ = scan.first_angle_rad;
  step_ = scan.angle_step_rad;
  turn_ = turn;
  directions_.resize(scan.ranges_m.size());
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const SineCosine angle = sine_cosine(turn_ + first_ + static_cast<double>(i) * step_);
    directions_[i] = {angle.cosine, angle.sine};
  }
}

bool take_points(const LaserScan& scan, BeamTable& beams, std::vector<ScanPoint>& points,
                 ScanLineCounts& counts) {
  points.clear();
  counts = {};
  if (!usable_scan(scan)) return false;
  beams.update(scan);
  counts.beams = static_cast<std::uint32_t>(scan.ranges_m.size());
  const double limit = scan.max_range_m > 0 ? scan.max_range_m : farthest_m;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const auto range = static_cast<double>(scan.ranges_m[i]);
    if (!(range > 0) || !std::isfinite(range)) {
      ++counts.no_reading;
    } else if (range >= limit || range >= farthest_m) {
      ++counts.beyond_range;
    } else {
      points.push_back({scan.laser_in_robot.x_m + range * beams[i].x,
                        scan.laser_in_robot.y_m + range * beams[i].y, range, static_cast<std::uint32_t>(i)});
    }
  }
  if (scan.angle_step_rad < 0) std::reverse(points.begin(), points.end());
  if (is_circle(scan) && points.size() > 2) cut_at_widest_gap(points);
  return true;
}

double allowed_gap(const ScanPoint& a, const ScanPoint& b, const ScanLineOptions& options,
                   double angle_step_rad) {
  return options.max_gap_m + spread * std::max(a.range_m, b.range_m) * std::fabs(angle_step_rad);
}

}  // namespace straightedge::localize
