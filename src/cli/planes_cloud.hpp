// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "cli/planes_run.hpp"

namespace straightedge::cli {

/// A cloud through every method, into one map a method; the sensor stands at the origin of the world.
/// bad_content: a file that is no cloud, or has no points.
Result<PlanesRun> run_cloud(const PlanesArguments& arguments, const std::filesystem::path& file);

}  // namespace straightedge::cli
