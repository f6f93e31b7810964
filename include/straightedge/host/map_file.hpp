// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The version of the format that is written; files of higher versions are refused.
inline constexpr int map_format_version = 1;

/// A longer file is refused before it is read.
inline constexpr std::size_t max_map_file_bytes = std::size_t{256} << 20;

/// A rule of the format that a map breaks, and where.
struct MapBreach {
  std::optional<std::size_t> line;     ///< index into `lines`; none: the map or its image
  std::optional<std::size_t> segment;  ///< index into the line's `segments`; none: the line itself
  std::string sentence;                ///< names the element by its id
};

/// Every rule that the map breaks, in the map's order; empty for a good map. The rules:
///  1. numbers are finite; the image has pixels; its resolution is above zero, its yaw within
///     `max_origin_yaw`; thresholds lie in 0 to 1, free_thresh <= occupied_thresh;
///  2. ids of lines are unique, and so are ids of segments in the whole map;
///  3. rho >= 0 and −pi < theta <= pi (rho = 0: −pi/2 < theta <= pi/2); a width is not negative;
///  4. variances are not negative;
///  5. a segment's ends differ, lie on their line within 1e-6·max(1, size) and are ordered along
///     (−sin theta, cos theta). size: the largest of the segment's coordinates and, in pixels, of the image's
///     sides.
std::vector<MapBreach> check_line_map(const LineMap& map);

/// The map as XML text. Numbers are the shortest that read back to the same bits; writing what was
/// read gives the same bytes. In texts, control characters become blanks and bytes that are not UTF-8
/// become U+FFFD, since XML cannot hold them. A map that breaks a rule is refused (`bad_option`).
Result<std::string> line_map_to_xml(const LineMap& map);

/// The inverse. `name` is what the sentences of failures call the text. Breaches of the format's rules
/// (docs/map-format.md) are refused with the element's id and line; unknown elements and attributes are
/// passed over. Refused too: document types, more than 100 nested elements, maps of planes, a higher
/// version.
Result<LineMap> line_map_from_xml(const std::string& xml, const std::string& name);

Result<Done> write_line_map(const std::filesystem::path& file, const LineMap& map);
Result<LineMap> read_line_map(const std::filesystem::path& file);

/// What `straightedge validate` prints: a sentence with file name and line for each rule that the file
/// breaks; empty for a good file. A file whose elements cannot be read at all is a failure.
Result<std::vector<std::string>> validate_line_map(const std::filesystem::path& file);

/// The same map in the world's frame. Needs `map.image->placement`; a metre map comes back as it is.
/// Where a normal turns round to keep rho >= 0, `free` and the order of the ends follow it.
Result<LineMap> to_metres(const LineMap& map);

}  // namespace straightedge
