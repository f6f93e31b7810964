// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"

/// A picture of a floor plan, drawn instead of taken by a camera, and how well segments fit the faces of its
/// walls.
namespace firmware {

/// Dark walls on a light floor, with noise.
void draw_plan(straightedge::ImageView<std::uint8_t> out) noexcept;

/// 255 where wall and floor meet, as an edge detector would say it: some pixels out of line, some missing,
/// some where there is nothing; else 0.
void draw_plan_edges(straightedge::ImageView<std::uint8_t> out) noexcept;

/// How well segments and the plan's faces lie on one another.
struct PlanScore {
  std::uint32_t recall_percent = 0;     ///< of the faces' length, within two pixels of a segment
  std::uint32_t precision_percent = 0;  ///< of the segments' length, within two pixels of a face
};
PlanScore score_plan(straightedge::Size size, std::span<const straightedge::HoughSegment> segments) noexcept;

}  // namespace firmware
