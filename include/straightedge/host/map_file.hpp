// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The map as XML text. Numbers are the shortest that read back to the same bits; writing what was
/// read gives the same bytes.
Result<std::string> line_map_to_xml(const LineMap& map);

/// The inverse. `name` is what the sentences of failures call the text. Breaches of the format's rules
/// (docs/map-format.md) are refused with the element's id and line; unknown elements and attributes are
/// passed over.
Result<LineMap> line_map_from_xml(const std::string& xml, const std::string& name);

Result<Done> write_line_map(const std::filesystem::path& file, const LineMap& map);
Result<LineMap> read_line_map(const std::filesystem::path& file);

/// The same map in the world's frame. Needs `map.image->placement`; a metre map comes back as it is.
Result<LineMap> to_metres(const LineMap& map);

}  // namespace straightedge
