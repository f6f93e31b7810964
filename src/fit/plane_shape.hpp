// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/frame_planes.hpp"

namespace straightedge::detail {

/// What becomes of a plane that leaves, in place of an index.
constexpr std::uint16_t gone = 0xFFFF;

enum class PlaneShape : std::uint8_t {
  flat,    ///< a plane
  stripe,  ///< no solid pieces: pixels along a crease or an edge
  bent,    ///< a strip of a ball, a pillar, a curtain
};

/// Step 5 of frame_planes.hpp: judges one plane.
///
/// 1. Stripe: solid pieces hold less than half of the plane's cells.
/// 2. Bent: of the least squares of 1, u, v, uu, uv, vv to the means of its cells the last three terms'
///    share is the bend.
PlaneShape plane_shape(std::uint32_t cells, std::uint32_t solid, const QuadraticSums& sums, Size picture,
                       const FramePlanesOptions& options, const PinholeCamera& camera) noexcept;

}  // namespace straightedge::detail
