// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// bad_option when one is out of its range; NaN is.
inline Result<Done> check_options(const PlaneMapOptions& o) {
  const auto between = [](double value, double low, double high) { return value >= low && value <= high; };
  const bool good = o.gate.valid() && between(o.floor.angle_rad, 0, 1) && between(o.floor.offset_m, 0, 1) &&
                    between(o.reading_floor, 0, 10) && between(o.shared_noise, 1, 1e6) &&
                    between(o.chi_square, 1e-9, 1e9) && between(o.max_angle, 0, 1) &&
                    between(o.max_offset, 0, 1) && between(o.max_tilt, 0, 2) && between(o.copy_angle, 0, 1) &&
                    between(o.copy_offset, 0, 1) && between(o.max_residual, 1e-9, 1e9) &&
                    between(o.min_area, 0, 1e6) && between(o.max_gap, 0, 10) && between(o.max_hole, 0, 1e6);
  if (!good) return Failure{Problem::bad_option, "an option of the plane map is out of its range"};
  return Done{};
}

}  // namespace straightedge
