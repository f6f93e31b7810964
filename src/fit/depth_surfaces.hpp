// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/detail/quadratic_surface.hpp"

namespace straightedge::detail {

/// The plane for cells counted from (u0, v0).
inline DepthSurface in_floats(const BentPlane& plane, double u0, double v0) noexcept {
  const InverseDepthPlane flat = plane.tangent(u0, v0);
  return {static_cast<float>(plane.at(u0, v0)), static_cast<float>(flat.a),   static_cast<float>(flat.b),
          static_cast<float>(plane.uu),         static_cast<float>(plane.uv), static_cast<float>(plane.vv)};
}

inline DepthSurface surface_of(const DepthSurfaces& s, std::size_t k) noexcept {
  return {s.c[k], s.x[k], s.y[k], s.xx[k], s.xy[k], s.yy[k]};
}

inline void fill_surfaces(std::span<const BentPlane> planes, const DepthCells& cells,
                          const DepthSurfaces& out) noexcept {
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const DepthSurface s = in_floats(planes[k], cells.middle_u(), cells.middle_v());
    out.c[k] = s.c;
    out.x[k] = s.x;
    out.y[k] = s.y;
    out.xx[k] = s.xx;
    out.xy[k] = s.xy;
    out.yy[k] = s.yy;
  }
}

}  // namespace straightedge::detail
