// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "map/plane_frame.hpp"
#include "map/plane_row.hpp"
#include "map/plane_runs.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge {

/// Steps 1 to 3 of the builder, four rows of pixels at a time. Labels are at most planes.size().
PlaneRowCounts register_depth(const DepthView& depth, ImageView<const std::uint16_t> labels,
                              std::span<const FramePlane> planes, const Pose& world_from_camera,
                              PlaneRuns& runs, const PlaneRowKernels& kernels);

/// The same for a cloud, where every point is a bundle of its own.
PlaneRowCounts register_points(const PointsView& points, std::span<const std::uint16_t> labels,
                               std::span<const FramePlane> planes, const Pose& world_from_sensor,
                               PlaneRuns& runs);

}  // namespace straightedge
