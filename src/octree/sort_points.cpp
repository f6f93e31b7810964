// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/sort_points.hpp"

#include "octree/cells_of.hpp"

namespace straightedge::octree {
namespace {

constexpr std::uint32_t part_mask = (std::uint32_t{1} << SortedRuns::code_bits) - 1;

/// What step 1 found.
struct Runs {
  bool fit = true;
  std::uint32_t points = 0;
  std::uint32_t count = 0;    ///< of runs
  std::uint64_t varying = 0;  ///< bits in which codes differ
  std::uint64_t any = 0;      ///< bits that some code has
};

/// Step 1, point by point: writes a pair for each run that has ended.
class RunReader {
 public:
  RunReader(std::uint32_t most, const Pairs& pairs) noexcept : most_(most), pairs_(pairs) {}

  /// Points `begin` and on; false when they are too many.
  bool read(const CellBatch& cells, std::size_t begin, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
      const bool same = ((cells.x[i] ^ x_) | (cells.y[i] ^ y_) | (cells.z[i] ^ z_)) == 0;
      if (same && begin + i - first_ < SortedRuns::most_points) continue;
      if (!end(begin + i)) return false;
      first_ = begin + i;
      x_ = cells.x[i];
      y_ = cells.y[i];
      z_ = cells.z[i];
    }
    return true;
  }
  /// The run at hand ends before point `next`.
  bool end(std::size_t next) noexcept {
    if ((x_ | y_ | z_) < 0) return true;
    const auto length = static_cast<std::uint32_t>(next - first_);
    if (length > most_ - runs_.points) return false;
    runs_.points += length;
    const std::uint64_t code = morton_encode(
        {static_cast<std::uint32_t>(x_), static_cast<std::uint32_t>(y_), static_cast<std::uint32_t>(z_)});
    all_ &= code;
    runs_.any |= code;
    const auto part = static_cast<std::uint32_t>(code) & part_mask;
    pairs_.set(runs_.count++,
               {part | (length - 1) << SortedRuns::code_bits, static_cast<std::uint32_t>(first_)});
    return true;
  }
  Runs finish(std::size_t count) noexcept {
    runs_.fit = end(count);
    runs_.varying = runs_.count == 0 ? 0 : all_ ^ runs_.any;
    return runs_;
  }

 private:
  std::uint32_t most_;
  Pairs pairs_;
  Runs runs_;
  std::uint64_t all_ = morton_codes - 1;
  std::int32_t x_ = -1, y_ = -1, z_ = -1;
  std::size_t first_ = 0;
};

Runs read_runs(const PointsView& view, const OctreeGrid& grid, std::uint32_t most,
               const Pairs& pairs) noexcept {
  RunReader reader(most, pairs);
  CellBatch cells;
  for (std::size_t begin = 0; begin < view.count; begin += CellBatch::size) {
    const std::size_t left = view.count - begin;
    const std::size_t count = left < CellBatch::size ? left : CellBatch::size;
    cells_of(view, grid, begin, count, cells);
    if (!reader.read(cells, begin, count)) return {false, 0, 0, 0, 0};
  }
  return reader.finish(view.count);
}

std::uint64_t code_at(const PointsView& view, const OctreeGrid& grid, std::size_t i) noexcept {
  MortonCell cell;
  (void)grid.cell_of(view.at(i), cell);
  return morton_encode(cell);
}

/// Puts the next nine levels in the place of those by which the runs are in order already.
void read_part(const PointsView& view, const OctreeGrid& grid, unsigned shift, const Pairs& pairs) noexcept {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pairs::Pair run = pairs[i];
    const auto part = static_cast<std::uint32_t>(code_at(view, grid, run.index) >> shift) & part_mask;
    pairs.set(i, {(run.key & ~part_mask) | part, run.index});
  }
}

}  // namespace

std::uint64_t SortedRuns::code(const Pairs::Pair& run, const PointsView& view,
                               const OctreeGrid& grid) const noexcept {
  return one_part ? above | (run.key & part_mask) : code_at(view, grid, run.index);
}

SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, std::uint32_t most,
                     std::span<std::uint32_t> memory, std::span<std::uint32_t> counts) noexcept {
  // Step 1
  const Runs runs = read_runs(view, grid, most, Pairs(memory));
  if (!runs.fit) return {};

  // Step 2: nine levels at a time, so that a pair takes 8 bytes, and pairs in two places 16, as points do.
  const std::size_t pair_words = 2 * std::size_t{runs.count};
  const Pairs front(memory.first(pair_words));
  const Pairs back(memory.first(octree_point_words * runs.points).last(pair_words));
  Pairs pairs = front;
  for (unsigned shift = 0; shift == 0 || runs.varying >> shift != 0; shift += SortedRuns::code_bits) {
    if (shift > 0) read_part(view, grid, shift, pairs);
    const auto varying = static_cast<std::uint32_t>(runs.varying >> shift) & part_mask;
    pairs = radix_sort(pairs, pairs.same_memory(front) ? back : front, varying, counts);
  }
  if (!pairs.same_memory(back))
    for (std::size_t i = 0; i < back.size(); ++i) back.set(i, front[i]);
  const bool one_part = runs.varying >> SortedRuns::code_bits == 0;
  return {true, runs.points, one_part, runs.any >> SortedRuns::code_bits << SortedRuns::code_bits, back};
}

}  // namespace straightedge::octree
