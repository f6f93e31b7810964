// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/host/scan_lines.hpp"
#include "straightedge/line_fit.hpp"

namespace straightedge::localize {

struct Laser {
  double x_m = 0, y_m = 0;  ///< in the robot's frame
};

/// Step 5 of scan_lines.hpp for the points with these indices; without floors. False: no line (all points in
/// one place).
bool fit_points(std::span<const ScanPoint> points, std::span<const std::uint32_t> members, const Laser& laser,
                const ScanLineOptions& options, LineFit& fit);

/// Step 6. The members are in the order of the points.
ScanLine line_of(std::span<const ScanPoint> points, std::span<const std::uint32_t> members,
                 const Laser& laser, const ScanLineOptions& options, const LineFit& fit);

}  // namespace straightedge::localize
