// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/pose2.hpp"

namespace straightedge {

/// What a path on the floor is; each kind has its colour and its entry in the legend.
enum class FloorPath : std::uint8_t { robot, truth, odometry };

struct FloorWay {
  FloorPath kind = FloorPath::robot;
  std::vector<Point2> points;
};

/// What became of a line of a scan.
enum class FloorLine : std::uint8_t { seen, matched, refused };

struct FloorSegment {
  FloorLine kind = FloorLine::seen;
  Point2 from, to;
  std::string label;  ///< beside its middle; may be empty
};

/// A robot's place, as an arrow head that points along its heading.
enum class FloorRobot : std::uint8_t { robot, start, end, pose, expected, candidate, lost };

struct FloorMark {
  FloorRobot kind = FloorRobot::pose;
  Pose2 pose;
  std::optional<std::array<double, 9>> covariance;  ///< drawn as the ellipse of three sigma
};

/// What is laid over the walls of a map. Metres of the map's world, y upwards.
struct FloorDrawing {
  std::string title;
  std::string description;  ///< for programs: who made it, with which options
  std::vector<Point2> readings;
  std::vector<FloorWay> ways;
  std::vector<FloorSegment> segments;
  std::vector<FloorMark> marks;
  std::vector<std::uint32_t> bold_walls;  ///< ids of the map's segments that stand out, with their ids
  std::vector<Point2> view;               ///< the drawing shows what surrounds these; none: the whole map
};

/// The walls of a metre map, thin readings on them, ways, marks, a scale and a legend of what is there, as a
/// drawing that any browser opens. Of readings that fall on one spot of the drawing the first is drawn, so
/// that a thousand scans of one wall cost what one does. Points that no Pose2 may have
/// (pose2.hpp) are left out. The same drawing gives the same bytes.
std::string floor_to_svg(const LineMap& metre_map, const FloorDrawing& drawing);

}  // namespace straightedge
