// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/frame_planes.hpp"

namespace straightedge::detail {

enum class PlaneShape : std::uint8_t {
  flat,    ///< a plane
  stripe,  ///< no solid pieces: pixels along a crease or an edge
  bent,    ///< a strip of a ball, a pillar, a curtain
};

/// Memory for `plane_shape`.
struct ShapeMemory {
  std::span<std::uint16_t> visited;  ///< one entry for each smallest cell; all zero before the first plane
  std::span<std::int32_t> runs;      ///< one more for each row of them
};

/// Every `step`-th cell of runs in rows, given as begin, end, begin, end, ...
template <class Visit>
void for_cells(std::span<const std::int32_t> runs, std::size_t step, const Visit& visit) noexcept {
  std::size_t i = 0, skip = 0;
  for (std::size_t run = 0; run < runs.size(); run += 2) {
    const auto end = static_cast<std::size_t>(runs[run + 1]);
    for (i = static_cast<std::size_t>(runs[run]) + skip; i < end; i += step) visit(i);
    skip = i - end;
  }
}

/// The labels of the smallest cells, and the plane that is looked at: how many carry its label, and the first
/// of them.
struct LabelledCells {
  std::span<std::uint16_t> labels;
  std::uint16_t label;
  std::size_t first, count;
};

/// Step 5 of frame_planes.hpp: judges one plane.
/// `solid` is how many entries of the runs are its solid pieces afterwards.
///
/// 1. Solid pieces: from the plane's cells, flood over touching cells whose readings lie on the plane,
///    whoever has them; a piece with too few cells of the plane's own is none,
///    and with `drop_crumbs` loses its label when it is a mere crumb.
/// 2. Stripe: solid pieces hold less than half of the plane's cells.
/// 3. Bent: least squares of 1, u, v, uu, uv, vv to the means of the solid cells, by Cholesky's
/// decomposition; the last
///    three terms' share is the bend.
PlaneShape plane_shape(const DepthCells& cells, const LabelledCells& plane, const BentPlane& surface,
                       const FramePlanesOptions& options, double min_pixels, const PinholeCamera& camera,
                       const ShapeMemory& memory, bool drop_crumbs, std::size_t& solid) noexcept;

}  // namespace straightedge::detail
