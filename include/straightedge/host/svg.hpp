// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

struct SvgOptions {
  /// The map's own picture, embedded under the lines; without pixels: none. Needs `map.image` of this
  /// size, and for a metre map its placement too.
  GrayView picture;
  bool ids = true;         ///< the segments' ids
  bool free_sides = true;  ///< ticks on the side where the floor is open
  bool legend = true;      ///< below the drawing
};

/// The map as a drawing that any browser opens, y upwards: faces of walls and axes of thin walls in two
/// colours, the width of thin walls as a light band. It is scaled to at least 900 pixels on its longer side.
/// The same map gives the same bytes.
///
/// Fails with `bad_option` when the map breaks its rules (check_line_map) or the picture is not the map's.
Result<std::string> line_map_to_svg(const LineMap& map, const SvgOptions& options = {});

Result<Done> write_svg(const std::filesystem::path& file, const LineMap& map, const SvgOptions& options = {});

}  // namespace straightedge
