// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_nodes.hpp"

namespace straightedge::octree {

/// Merges the first `old_count` points with the `new_count` that begin at `new_place`, behind them, both in
/// the order of their codes; of one cell the old ones come first. New points are moved aside in pieces of
/// lent.size(); each piece costs at most a pass over the points before it.
void merge_points(const OctreeGrid& grid, std::span<std::uint32_t> words, std::uint32_t old_count,
                  std::uint32_t new_place, std::uint32_t new_count, std::span<OctreeNode> lent) noexcept;

}  // namespace straightedge::octree
