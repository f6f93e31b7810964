// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "caller_memory.hpp"

/// Every algorithm of the core that looks at views or works in a workspace: a new one is a row more in
/// one of the tables.
namespace workspace {

struct Algorithm {
  const char* name;
  /// Prepares and runs with memory from `memory` alone and says its results there. Gives what was not ok.
  Status (*run)(CallerMemory& memory);
};

std::span<const Algorithm> edge_algorithms();
std::span<const Algorithm> line_algorithms();
std::span<const Algorithm> plane_algorithms();
std::span<const Algorithm> octree_algorithms();

/// The status of a whole call. What could not be prepared must not run.
Status whole(Status prepared, Status ran);

}  // namespace workspace
