// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "octree/code_reader.hpp"
#include "octree/radix_sort.hpp"
#include "straightedge/octree_point.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::octree {

/// Points of one cell that follow one another in a view, in the order of cells: a pair's index is the
/// run's first point, and the run ends with the first point that is not in its cell. A scan has
/// several times fewer runs than points.
struct SortedRuns {
  bool fit = false;          ///< false: there are more points in the cube than may be
  std::uint32_t points = 0;  ///< in the cube
  Pairs pairs;               ///< at the end of the memory that so many points take
};

/// Steps 1 and 2, in memory for `most` points.
SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, std::uint32_t most,
                     std::span<std::uint32_t> memory, std::span<std::uint32_t> counts) noexcept;

/// Step 3: copies the points of the runs to the start of the same memory and calls leaf(code, place) for the
/// first point of each cell. Each run that waits has a point and takes half of its room, and points are
/// written by full blocks: no run is written over before it has been read.
template <class Leaf>
void copy_points(const SortedRuns& runs, const PointsView& view, const OctreeGrid& grid,
                 std::uint32_t first_index, std::span<std::uint32_t> memory, Leaf leaf) noexcept {
  constexpr std::size_t block_words = octree_block_points * octree_point_words;
  CodeReader reader(grid);
  std::uint64_t last = morton_codes;
  std::uint32_t place = 0;
  std::uint32_t block[block_words] = {};
  const auto write_block = [&](std::size_t begin) {
    for (std::size_t i = 0; i < block_words; ++i) memory[begin * octree_point_words + i] = block[i];
  };
  for (std::size_t run = 0; run < runs.pairs.size(); ++run) {
    std::size_t i = runs.pairs[run].index;
    const std::uint64_t code = reader.code_of(view.at(i));
    if (code != last) leaf(code, place);
    last = code;
    do {
      const Vector3 p = view.at(i);
      OctreePoint{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                  first_index + static_cast<std::uint32_t>(i)}
          .write(block, place % octree_block_points);
      if (++place % octree_block_points == 0) write_block(place - octree_block_points);
    } while (++i < view.count && reader.same_cell(view.at(i)));
  }
  if (place % octree_block_points != 0) write_block(place - place % octree_block_points);
}

}  // namespace straightedge::octree
