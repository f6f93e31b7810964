// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/line_geometry.hpp"

namespace straightedge::io {

/// A turn, a scale and a shift of the plane: p -> scale·R·p + (x, y).
struct Similarity {
  double scale = 1;
  SineCosine turn;
  double x = 0, y = 0;

  constexpr Point2 operator()(Point2 p) const noexcept {
    return {scale * (turn.cosine * p.x - turn.sine * p.y) + x,
            scale * (turn.sine * p.x + turn.cosine * p.y) + y};
  }
  constexpr Similarity inverse() const noexcept {
    const Similarity back{1 / scale, {-turn.sine, turn.cosine}, 0, 0};
    const Point2 origin = back({x, y});
    return {back.scale, back.turn, -origin.x, -origin.y};
  }
};

/// From the centre frame of an image to the world: (ox, oy) + R(yaw)·s·(x + W/2, y + H/2).
constexpr Similarity world_from_centre(const MapPlacement& placement, Size size) noexcept {
  Similarity world{placement.resolution, sine_cosine(placement.origin_yaw), placement.origin_x,
                   placement.origin_y};
  const Point2 centre = world({0.5 * size.width, 0.5 * size.height});
  world.x = centre.x;
  world.y = centre.y;
  return world;
}

}  // namespace straightedge::io
