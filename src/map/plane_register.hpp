// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "map/plane_frame.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge {

/// Readings that found no place.
struct LeftOut {
  std::uint64_t off_plane = 0;
  std::uint64_t out_of_range = 0;
};

/// Steps 1 to 3 of the builder, pixel by pixel. Labels are at most planes.size().
LeftOut register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                       std::span<const FramePlane> planes, const Pose& world_from_camera, LeafWriter& writer);

/// The same for a cloud, point by point.
LeftOut register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                        std::span<const FramePlane> planes, const Pose& world_from_sensor,
                        LeafWriter& writer);

}  // namespace straightedge
