// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/octree_grid.hpp"

namespace straightedge {
namespace {

void extend(double value, double& low, double& high) noexcept {
  if (value < low) low = value;
  if (value > high) high = value;
}

double longest_side(const OctreeBox& box) noexcept {
  const Vector3 size = box.max - box.min;
  double longest = size.x;
  if (size.y > longest) longest = size.y;
  if (size.z > longest) longest = size.z;
  return longest;
}

}  // namespace

OctreeFit fit_octree_grid(const PointsView& points, double leaf_m) noexcept {
  OctreeFit fit;
  fit.grid.leaf_m = leaf_m;
  if (!fit.grid.valid()) {
    fit.status = Status::invalid_option;
    return fit;
  }
  if (!points.valid()) return fit;
  for (std::size_t i = 0; i < points.count; ++i) {
    const Vector3 p = points.at(i);
    if (!finite(p)) continue;
    if (fit.points++ == 0) fit.box = {p, p};
    extend(p.x, fit.box.min.x, fit.box.max.x);
    extend(p.y, fit.box.min.y, fit.box.max.y);
    extend(p.z, fit.box.min.z, fit.box.max.z);
  }
  if (fit.points == 0) return fit;

  // The smallest corner comes to lie in the middle of cell 2^20, 2^20, 2^20.
  constexpr auto half = static_cast<double>(morton_side / 2);
  while (longest_side(fit.box) > (half - 1) * fit.grid.leaf_m) fit.grid.leaf_m *= 2;
  const double back = (half - octree_origin_cell + 0.5) * fit.grid.leaf_m;
  fit.grid.origin = fit.box.min - Vector3{back, back, back};
  fit.status = Status::ok;
  return fit;
}

}  // namespace straightedge
