// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// The YAML file of ROS's map_server.
struct RosMap {
  std::filesystem::path image;  ///< as a path that can be opened: relative names are relative to the YAML
  MapPlacement placement;
  RosMeaning meaning;
};

/// `image`, `resolution`, `origin`, `negate`, `occupied_thresh` and `free_thresh` are required, `mode`
/// (trinary, scale, raw) is not: old files lack it.
Result<RosMap> read_ros_map(const std::filesystem::path& file);

}  // namespace straightedge
