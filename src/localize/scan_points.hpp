// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "straightedge/host/scan_lines.hpp"

namespace straightedge::localize {

/// Directions of the beams in the robot's frame. Computed anew only when the scanner changes.
class BeamTable {
 public:
  void update(const LaserScan& scan);

  struct Direction {
    double x = 1, y = 0;
  };
  const Direction& operator[](std::size_t beam) const { return directions_[beam]; }

 private:
  std::vector<Direction> directions_;
  double first_ = 0, step_ = 0, turn_ = 0;
};

/// Step 1 of scan_lines.hpp. False: the scan cannot be used.
bool take_points(const LaserScan& scan, BeamTable& beams, std::vector<ScanPoint>& points,
                 ScanLineCounts& counts);

/// The allowed distance of two neighbours of one thing: a wall seen at a small angle spreads its points.
double allowed_gap(const ScanPoint& a, const ScanPoint& b, const ScanLineOptions& options,
                   double angle_step_rad);

}  // namespace straightedge::localize
