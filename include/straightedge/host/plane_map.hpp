// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/host/line_map.hpp"
#include "straightedge/plane.hpp"

namespace straightedge {

/// From which side a plane was seen, relative to its normal.
enum class SeenSide : std::uint8_t { unknown, plus, minus, both };

/// A closed border of a plane's extent; its points lie on the plane. Outer borders run counter-clockwise
/// seen from where the normal points, holes clockwise. The last point is not the first again.
struct MapPolygon {
  bool hole = false;
  std::vector<Vector3> points;

  bool operator==(const MapPolygon&) const = default;
};

/// Sum of the weights (1/sigma², 1/m²), mean point, scatter xx xy xz yy yz zz about it.
struct MapMoments {
  double weight = 0;
  Vector3 mean;
  std::array<double, 6> scatter{};

  bool operator==(const MapMoments&) const = default;
};

struct MapPlane {
  std::uint32_t id = 0;  ///< unique in the map; found planes count from 1: 0 is "no plane" in label images
  Plane plane;
  std::optional<std::uint64_t> points;  ///< readings that carry it
  std::optional<std::uint32_t>
      count;  ///< planes of frames that became part of it; a frame may see it in pieces
  std::optional<std::string> source;  ///< the method that found it
  SeenSide seen = SeenSide::unknown;
  std::optional<std::array<double, 10>> covariance;  ///< see covariance_4x4
  std::optional<MapMoments> moments;
  std::vector<MapPolygon> polygons;

  bool operator==(const MapPlane&) const = default;
};

/// World frame, metres, right-handed.
struct PlaneMap {
  MapMeta meta;
  std::vector<MapPlane> planes;

  bool operator==(const PlaneMap&) const = default;
};

}  // namespace straightedge
