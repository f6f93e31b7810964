// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// The picture to look at, and what a ROS map says about it.
struct MapSource {
  std::filesystem::path picture;
  std::optional<MapPlacement> placement;
  std::optional<RosMeaning> meaning;
};

/// By its name, the input is the YAML file of a ROS map.
bool is_ros_map(const std::string& input);

/// Reads the YAML file where there is one; any other input is the picture itself.
Result<MapSource> find_map_source(const std::string& input);

}  // namespace straightedge::cli
