// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/image.hpp"

namespace straightedge {

/// On which side of a line the open floor is, relative to the normal (cos theta, sin theta).
enum class FreeSide : std::uint8_t { unknown, plus, minus, both };

enum class MapUnit : std::uint8_t {
  pixel,  ///< origin at the image's centre, x right, y up
  metre,  ///< origin and axes of the world
};

/// Covariance of a line about the point (at_x, at_y) of it, its centroid, where angle and offset do
/// not depend on one another.
struct LineCovariance {
  double at_x = 0;
  double at_y = 0;
  double var_theta = 0;   ///< radians²
  double var_offset = 0;  ///< units²

  bool operator==(const LineCovariance&) const = default;
};

/// A piece of a line where there is wall. The end points lie on the line, ordered along
/// (−sin theta, cos theta).
struct MapSegment {
  std::uint32_t id = 0;  ///< unique among the segments of the map
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::optional<std::uint32_t> pixels;  ///< edge pixels that carry it

  bool operator==(const MapSegment&) const = default;
};

/// x cos theta + y sin theta = rho with rho >= 0 and −pi < theta <= pi (rho = 0: −pi/2 < theta <= pi/2).
struct MapLine {
  std::uint32_t id = 0;  ///< unique among the lines of the map
  double rho = 0;
  double theta = 0;
  std::optional<std::uint32_t> votes;  ///< of the Hough transform; or pixels of edges that were followed
  std::optional<double> width;         ///< of a thin wall whose axis this is; absent: the face of a wall
  std::optional<std::uint32_t> count;  ///< how many observations were merged into it
  std::optional<std::string> source;
  FreeSide free = FreeSide::unknown;
  std::optional<LineCovariance> covariance;
  std::vector<MapSegment> segments;

  bool operator==(const MapLine&) const = default;
};

/// How the values of a ROS map image mean occupied, free and unknown; ROS map_server's own rules.
enum class RosMapMode : std::uint8_t { trinary, scale, raw };

struct RosMeaning {
  bool negate = false;  ///< bright is wall
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  RosMapMode mode = RosMapMode::trinary;

  bool operator==(const RosMeaning&) const = default;
};

/// Where the image lies in the world: metres a pixel, and the pose of the lower left pixel's corner.
struct MapPlacement {
  double resolution = 0.05;
  double origin_x = 0;
  double origin_y = 0;
  double origin_yaw = 0;  ///< radians

  bool operator==(const MapPlacement&) const = default;
};

struct MapImage {
  std::string file;
  Size size;
  std::optional<MapPlacement> placement;
  std::optional<RosMeaning> meaning;

  bool operator==(const MapImage&) const = default;
};

struct MapMeta {
  std::string name;
  std::string description;
  std::string tool;     ///< name and version of the writer
  std::string options;  ///< the command's options in words, seed included
  std::string created;  ///< only when the caller gives it

  bool operator==(const MapMeta&) const = default;
};

struct LineMap {
  MapMeta meta;
  MapUnit unit = MapUnit::pixel;
  std::optional<MapImage> image;
  std::vector<MapLine> lines;

  bool operator==(const LineMap&) const = default;
};

}  // namespace straightedge
