// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// The camera of a depth picture: the file that the user gave, else camera.json beside the picture or in the
/// folder above. `given`: empty for none. `units_per_metre` takes the place of the camera's own.
/// bad_option: no camera is known; else as read_camera.
Result<DepthCamera> find_depth_camera(const std::filesystem::path& picture, const std::string& given,
                                      std::optional<double> units_per_metre);

}  // namespace straightedge::cli
