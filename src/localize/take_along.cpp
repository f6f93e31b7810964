// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "localize/pieces.hpp"
#include "localize/scan_points.hpp"

namespace straightedge::localize {

void take_along(const PointRow& row, const LineFit& fit, double begin, double end, std::vector<char>& owned,
                Pieces& pieces) {
  const auto close = [&] {
    if (pieces.open().size() < row.options.min_points) return pieces.forget();
    for (const std::uint32_t i : pieces.open()) owned[i] = 1;
    pieces.close();
  };
  for (std::uint32_t i = 0; i < row.points.size(); ++i) {
    const ScanPoint& p = row.points[i];
    if (owned[i] != 0 || std::fabs(fit.distance(p.x_m, p.y_m)) > row.options.split_distance_m) continue;
    const double s = (p.y_m - fit.centroid_y) * fit.normal_x - (p.x_m - fit.centroid_x) * fit.normal_y;
    if (s < begin || s > end) continue;
    if (!pieces.open().empty()) {
      const ScanPoint& last = row.points[pieces.open().back()];
      const double limit = allowed_gap(last, p, row.options, row.angle_step_rad);
      const double dx = p.x_m - last.x_m, dy = p.y_m - last.y_m;
      if (dx * dx + dy * dy > limit * limit) close();
    }
    pieces.add(i);
  }
  close();
}

}  // namespace straightedge::localize
