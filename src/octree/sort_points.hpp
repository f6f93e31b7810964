// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "octree/radix_sort.hpp"
#include "straightedge/octree_grid.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/octree_point.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::octree {

/// Points of one cell that follow one another in a view, at most 32 of them, in the order of cells: a pair's
/// index is the run's first point. A scan has many times fewer runs than points.
///
/// The key of a pair is nine levels of the code, which is what it is sorted by, and above them the length.
struct SortedRuns {
  static constexpr unsigned code_bits = 27;
  static constexpr std::uint32_t part_mask = (std::uint32_t{1} << code_bits) - 1;
  static constexpr std::uint32_t most_points = std::uint32_t{1} << (32 - code_bits);

  bool fit = false;          ///< false: there are more points in the cube than may be
  std::uint32_t points = 0;  ///< in the cube
  bool one_part = true;      ///< codes differ within the nine lowest levels alone
  std::uint64_t above = 0;   ///< the part of the code above them, if so
  Pairs pairs;               ///< at the end of the memory that so many points take, and three more

  static std::uint32_t length(std::uint32_t key) noexcept { return (key >> code_bits) + 1; }
  std::uint64_t code(const Pairs::Pair& run, const PointsView& view, const OctreeGrid& grid) const noexcept {
    return one_part ? above | (run.key & part_mask) : code_at(view, grid, run.index);
  }
  /// Of point i, which must be in the cube.
  static std::uint64_t code_at(const PointsView& view, const OctreeGrid& grid, std::size_t i) noexcept;
};

/// Steps 1 and 2, in memory for `most` points and octree_spare_points.
SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, const OctreeKernels& kernels,
                     std::uint32_t most, std::span<std::uint32_t> memory,
                     std::span<std::uint32_t> counts) noexcept;

}  // namespace straightedge::octree
