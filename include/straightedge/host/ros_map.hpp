// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// Radians. Turning a map by more than this loses digits that its rules rely on.
inline constexpr double max_origin_yaw = 1000;

/// The YAML file of ROS's map_server.
struct RosMap {
  std::filesystem::path image;  ///< as a path that can be opened: relative names are relative to the YAML
  MapPlacement placement;
  RosMeaning meaning;
};

/// `image`, `resolution`, `origin`, `negate`, `occupied_thresh` and `free_thresh` are required, `mode`
/// (trinary, scale, raw) is not: old files lack it. Other keys are passed over.
///
/// Fails with `cannot_read` when the file cannot be opened or read, with `bad_content` when it is no YAML,
/// lacks a key, or a value is no finite number or out of its range: resolution above 0, thresholds from 0
/// to 1 with free_thresh <= occupied_thresh, yaw within `max_origin_yaw`.
Result<RosMap> read_ros_map(const std::filesystem::path& file);

}  // namespace straightedge
