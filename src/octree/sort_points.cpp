// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/sort_points.hpp"

namespace straightedge::octree {
namespace {

/// What step 1 found.
struct Runs {
  bool fit = true;
  std::uint32_t points = 0;
  std::uint32_t count = 0;    ///< of runs
  std::uint64_t varying = 0;  ///< bits in which codes differ
};

/// Writes a pair for each run: the lower half of its code, its first point.
Runs read_runs(const PointsView& view, const OctreeGrid& grid, std::uint32_t most,
               const Pairs& pairs) noexcept {
  Runs runs;
  MortonCell last;
  bool in_run = false;
  std::uint64_t all = morton_codes - 1, any = 0;
  for (std::size_t i = 0; i < view.count; ++i) {
    MortonCell cell;
    const bool inside = grid.cell_of(view.at(i), cell);
    in_run = in_run && inside && cell == last;
    if (!inside) continue;
    if (runs.points++ == most) return {false, 0, 0, 0};
    if (in_run) continue;
    in_run = true;
    last = cell;
    const std::uint64_t code = morton_encode(cell);
    all &= code;
    any |= code;
    pairs.set(runs.count++, {static_cast<std::uint32_t>(code), static_cast<std::uint32_t>(i)});
  }
  runs.varying = runs.count == 0 ? 0 : all ^ any;
  return runs;
}

/// Puts the upper halves in the place of the lower, by which the runs are in order already.
void read_upper_halves(const PointsView& view, const OctreeGrid& grid, const Pairs& pairs) noexcept {
  CodeReader reader(grid);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::uint32_t first = pairs[i].index;
    pairs.set(i, {static_cast<std::uint32_t>(reader.code_of(view.at(first)) >> 32U), first});
  }
}

}  // namespace

SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, std::uint32_t most,
                     std::span<std::uint32_t> memory, std::span<std::uint32_t> counts) noexcept {
  // Step 1
  const Runs runs = read_runs(view, grid, most, Pairs(memory));
  if (!runs.fit) return {};

  // Step 2: in two halves of the code, so that a pair takes 8 bytes, and pairs in two places 16, as points
  // do.
  const std::size_t pair_words = 2 * std::size_t{runs.count};
  const Pairs front(memory.first(pair_words));
  const Pairs back(memory.first(octree_point_words * runs.points).last(pair_words));
  Pairs pairs = radix_sort(front, back, static_cast<std::uint32_t>(runs.varying), counts);
  const auto varying_above = static_cast<std::uint32_t>(runs.varying >> 32U);
  if (varying_above != 0) {
    read_upper_halves(view, grid, pairs);
    pairs = radix_sort(pairs, pairs.same_memory(front) ? back : front, varying_above, counts);
  }
  if (!pairs.same_memory(back))
    for (std::size_t i = 0; i < back.size(); ++i) back.set(i, front[i]);
  return {true, runs.points, back};
}

}  // namespace straightedge::octree
