// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "straightedge/host/result.hpp"

// Which files of a folder are what; depth_sequence.hpp has the rules.
namespace straightedge::io {

bool is_file(const std::filesystem::path& file) noexcept;

/// The depth pictures in natural order; empty when there are none.
Result<std::vector<std::filesystem::path>> depth_files(const std::filesystem::path& folder);

/// The one file with the camera.
Result<std::filesystem::path> camera_file(const std::filesystem::path& folder);

/// The file with the pose of this frame alone, if there is one.
std::optional<std::filesystem::path> pose_file(const std::filesystem::path& folder,
                                               const std::filesystem::path& frame);

/// The file with the poses of all frames.
Result<std::filesystem::path> trajectory_file(const std::filesystem::path& folder);

}  // namespace straightedge::io
