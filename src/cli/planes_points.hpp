// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "cli/planes_run.hpp"

namespace straightedge::cli {

/// Wants readings with the id of their plane on one method's map (0: none).
struct PointSink {
  const MethodRun* method = nullptr;
  std::uint64_t step = 1;  ///< every so-manieth reading, of all frames counted together
  std::function<void(const Vector3& world, std::uint32_t id)> take;
};

/// The least step that leaves at most `most` of the readings and does not fall on the same columns of every
/// row.
std::uint64_t thinning_step(const PlanesRun& run, std::uint64_t most);

/// Reads the frames again, once for all sinks.
Result<Done> send_points(const PlanesRun& run, std::vector<PointSink>& sinks);

}  // namespace straightedge::cli
