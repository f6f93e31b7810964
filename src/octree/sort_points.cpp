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

/// Bit i to bit 3 i, of nine bits.
constexpr std::uint32_t spread_nine(std::uint32_t v) noexcept {
  v &= 0x1ff;
  v = (v | (v << 16U)) & 0x0300'00ff;
  v = (v | (v << 8U)) & 0x0300'f00f;
  v = (v | (v << 4U)) & 0x030c'30c3;
  return (v | (v << 2U)) & 0x0924'9249;
}

/// Cells at which runs start, a batch at a time and without branches: where runs end is anybody's guess.
struct RunStarts {
  std::uint32_t at[CellBatch::size];  ///< place in the batch
  std::uint32_t x[CellBatch::size], y[CellBatch::size], z[CellBatch::size];
  std::uint32_t part[CellBatch::size];  ///< of the code, its lowest nine levels
  std::uint32_t count = 0;

  void find(const CellBatch& cells, std::size_t points) noexcept {
    std::int32_t starts[CellBatch::size];
    cells.find_starts(starts);
    count = 0;
    for (std::size_t i = 0; i < points; ++i) {
      at[count] = static_cast<std::uint32_t>(i);
      count -= static_cast<std::uint32_t>(starts[i]);
    }
    for (std::uint32_t k = 0; k < count; ++k) {
      const MortonCell cell = cells.at(at[k]);
      x[k] = cell.x;
      y[k] = cell.y;
      z[k] = cell.z;
    }
    for (std::uint32_t k = 0; k < count; ++k)
      part[k] = spread_nine(x[k]) | spread_nine(y[k]) << 1U | spread_nine(z[k]) << 2U;
  }
  bool outside(std::uint32_t k) const noexcept { return static_cast<std::int32_t>(x[k] | y[k] | z[k]) < 0; }
};

/// Step 1: writes a pair for each run that has ended.
class RunReader {
 public:
  RunReader(std::uint32_t most, const Pairs& pairs) noexcept : most_(most), pairs_(pairs) {}

  /// Runs that start in the batch whose first point is `begin`.
  void read(const RunStarts& starts, std::size_t begin) noexcept {
    for (std::uint32_t k = 0; k < starts.count; ++k) {
      end(begin + starts.at[k]);
      first_ = begin + starts.at[k];
      inside_ = !starts.outside(k);
      part_ = starts.part[k];
      if (!inside_) continue;
      const MortonCell cell{starts.x[k], starts.y[k], starts.z[k]};
      all_ = {all_.x & cell.x, all_.y & cell.y, all_.z & cell.z};
      any_ = {any_.x | cell.x, any_.y | cell.y, any_.z | cell.z};
    }
  }
  Runs finish(std::size_t count) noexcept {
    end(count);
    runs_.any = morton_encode(any_);
    runs_.varying = runs_.count == 0 ? 0 : runs_.any ^ morton_encode(all_);
    return runs_;
  }

 private:
  /// The run at hand ends before point `next`.
  void end(std::size_t next) noexcept {
    if (!inside_ || !runs_.fit) return;
    const std::size_t length = next - first_;
    runs_.fit = length <= most_ - runs_.points;
    if (!runs_.fit) return;
    runs_.points += static_cast<std::uint32_t>(length);
    for (std::size_t left = length; left > 0;) {
      const std::size_t piece = left < SortedRuns::most_points ? left : SortedRuns::most_points;
      const auto from = static_cast<std::uint32_t>(next - left);
      pairs_.set(runs_.count++,
                 {part_ | static_cast<std::uint32_t>(piece - 1) << SortedRuns::code_bits, from});
      left -= piece;
    }
  }

  std::uint32_t most_;
  Pairs pairs_;
  Runs runs_;
  MortonCell all_{morton_side - 1, morton_side - 1, morton_side - 1}, any_;
  bool inside_ = false;
  std::uint32_t part_ = 0;
  std::size_t first_ = 0;
};

Runs read_runs(const PointsView& view, const OctreeGrid& grid, const OctreeKernels& kernels,
               std::uint32_t most, const Pairs& pairs) noexcept {
  RunReader reader(most, pairs);
  CellBatch cells;
  RunStarts starts;
  for (std::size_t begin = 0; begin < view.count; begin += CellBatch::size) {
    const std::size_t left = view.count - begin;
    const std::size_t count = left < CellBatch::size ? left : CellBatch::size;
    cells_of(view, grid, begin, count, kernels, cells);
    starts.find(cells, count);
    reader.read(starts, begin);
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

SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, const OctreeKernels& kernels,
                     std::uint32_t most, std::span<std::uint32_t> memory,
                     std::span<std::uint32_t> counts) noexcept {
  // Step 1
  const Runs runs = read_runs(view, grid, kernels, most, Pairs(memory));
  if (!runs.fit) return {};

  // Step 2: nine levels at a time, so that a pair takes 8 bytes, and pairs in two places 16, as points do.
  const std::size_t pair_words = 2 * std::size_t{runs.count};
  const Pairs front(memory.first(pair_words));
  const Pairs back(
      memory.first(octree_point_words * (runs.points + 2 * octree_block_points - 1)).last(pair_words));
  Pairs pairs = front;
  for (unsigned shift = 0; shift == 0 || (shift < 64 && runs.varying >> shift != 0);
       shift += SortedRuns::code_bits) {
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
