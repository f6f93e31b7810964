// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "straightedge/octree_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// What octree_kernels.hpp tells of it.
std::uint64_t find_near(const OctreeNearTask& task) noexcept;

/// How far away what may be nearest is at most, when the nearest in floats is at `least`: as FarFilter in
/// near_points.hpp raises its limit. Kernels share no inline functions with the rest.
inline float near_limit(const OctreeNearTask& task, float least) noexcept {
  const double raised = static_cast<double>(least) * task.slack + task.loss;
  const float reach = raised < 0x1p127 ? static_cast<float>(raised) : least;
  return reach < task.limit ? reach : task.limit;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
