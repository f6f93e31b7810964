// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "straightedge/canny.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/hough_lines.hpp"

namespace straightedge {

/// What the picture is of, which decides what may become a line.
enum class PictureKind : std::uint8_t {
  automatic,  ///< a map when most of it is light, even ground; else a photo
  map,        ///< dark walls on lighter ground; only what is dark is wall
  photo,      ///< every edge is a line
};

struct LineMapOptions {
  PictureKind picture = PictureKind::automatic;
  CannyOptions canny;
  HoughOptions hough;
  double min_length = 15;             ///< pixels; shorter segments are dropped
  double max_gap = 10;                ///< pixels; a hole in a wall up to this long is bridged
  double max_wall_width = 3.6;        ///< pixels; thinner walls become one axis, thicker ones keep both faces
  std::optional<RosMeaning> meaning;  ///< a ROS map's thresholds decide what is wall
};

/// What happened on the way, stage by stage.
struct LineMapReport {
  PictureKind picture = PictureKind::photo;  ///< what it was taken for
  CannyResult canny;
  HoughResult hough;
  std::uint32_t candidates = 0;   ///< segments of the Hough transform
  std::uint32_t refined = 0;      ///< that held as fitted lines with pixels of their own
  std::uint32_t walls = 0;        ///< pairs of edges joined into the axis of a thin wall
  std::uint32_t merged = 0;       ///< segments that became part of another one's line
  std::uint32_t too_short = 0;    ///< dropped for their length
  std::uint32_t unsupported = 0;  ///< dropped for lack of contrast in the picture
};

struct LineMapResult {
  LineMap map;
  LineMapReport report;
};

/// The whole way from gray picture to line map (docs/line-map.md).
Result<LineMapResult> build_line_map(GrayView gray, const LineMapOptions& options = {});

}  // namespace straightedge
