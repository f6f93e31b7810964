// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/map_source.hpp"

#include "cli/outputs.hpp"
#include "straightedge/host/ros_map.hpp"

namespace straightedge::cli {

bool is_ros_map(const std::string& input) {
  const std::string ending = lower_case(std::filesystem::path(input).extension().string());
  return ending == ".yaml" || ending == ".yml";
}

Result<MapSource> find_map_source(const std::string& input) {
  if (!is_ros_map(input)) return MapSource{.picture = input_path(input), .placement = {}, .meaning = {}};
  const auto map = read_ros_map(input);
  if (!map) return map.failure();
  return MapSource{map->image, map->placement, map->meaning};
}

}  // namespace straightedge::cli
