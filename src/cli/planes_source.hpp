// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/planes_arguments.hpp"

namespace straightedge::cli {

/// The frames of a folder, or a single depth picture, which stands at the origin of the world.
Result<DepthSequence> open_depth_source(const PlanesArguments& arguments);

}  // namespace straightedge::cli
