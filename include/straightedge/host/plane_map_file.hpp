// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A rule of the format that a plane map breaks, and where.
struct PlaneMapBreach {
  std::optional<std::size_t> plane;    ///< index into `planes`; none: the map
  std::optional<std::size_t> polygon;  ///< index into the plane's `polygons`; none: the plane itself
  std::string sentence;                ///< names the element by its id
};

/// Every rule that the map breaks, in the map's order:
///  1. numbers are finite; 2. ids are unique; 3. |n| = 1 within 1e-9, d >= 0 and the sign rule of plane.hpp;
///  4. the covariance is positive semidefinite within rounding, weight >= 0, the scatter is positive
///  semidefinite; 5. a polygon has three points or more, each within 1e-6·max(1, size) of the plane; outer
///  borders run counter-clockwise seen from where the normal points, holes clockwise.
std::vector<PlaneMapBreach> check_plane_map(const PlaneMap& map);

/// As with line maps (map_file.hpp): shortest round-trip numbers, write → read → write gives the same bytes.
Result<std::string> plane_map_to_xml(const PlaneMap& map);
Result<PlaneMap> plane_map_from_xml(const std::string& xml, const std::string& name);
Result<Done> write_plane_map(const std::filesystem::path& file, const PlaneMap& map);
Result<PlaneMap> read_plane_map(const std::filesystem::path& file);
Result<std::vector<std::string>> validate_plane_map(const std::filesystem::path& file);

enum class MapKind { lines, planes };
/// What kind of map an XML file holds, by its root element alone.
Result<MapKind> map_kind(const std::filesystem::path& file);
/// The same from a file's text; `name` is what the sentences of failures call it.
Result<MapKind> map_kind_from_xml(const std::string& xml, const std::string& name);

}  // namespace straightedge
