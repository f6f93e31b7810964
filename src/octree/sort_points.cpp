// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/sort_points.hpp"

#include "octree/cells_of.hpp"

namespace straightedge::octree {
namespace {

constexpr std::uint32_t low_levels = (std::uint32_t{1} << SortedRuns::code_bits / 3) - 1;
constexpr std::uint32_t part_mask = SortedRuns::part_mask;

/// What step 1 found.
struct Runs {
  bool fit = true;
  std::uint32_t points = 0;
  std::uint32_t count = 0;      ///< of runs
  std::uint64_t varying = 0;    ///< bits in which codes may differ
  std::uint64_t some_code = 0;  ///< any of them
};

/// Step 1: writes a pair for each run that has ended.
class RunReader {
 public:
  RunReader(std::uint32_t most, const Pairs& pairs) noexcept : most_(most), pairs_(pairs) {}

  /// Runs that start in the batch whose first point is `begin`.
  void read(const OctreeRunStarts& starts, std::size_t begin) noexcept {
    if (starts.count == 0) return;
    end(begin + starts.at[0]);
    if (!take_all(starts, begin)) {
      for (std::uint32_t k = 1; k < starts.count; ++k) {
        start(starts, k - 1, begin);
        end(begin + starts.at[k]);
      }
    }
    start(starts, starts.count - 1, begin);
  }
  Runs finish(const OctreeRunStarts& starts, std::size_t count) noexcept {
    end(count);
    if (runs_.count == 0) return runs_;
    const std::uint32_t above = starts.cell_differs & ~low_levels;
    runs_.some_code = morton_encode(starts.first);
    runs_.varying = starts.part_differs | morton_encode({above, above, above});
    return runs_;
  }

 private:
  static std::uint32_t key(std::uint32_t part, std::uint32_t length) noexcept {
    return part | (length - 1) << SortedRuns::code_bits;
  }
  /// The runs that end in the batch they start in, if they are as most are: in the cube, no longer than a
  /// pair can tell, and not more than fit. If not, what is written behind the pairs counts for nothing.
  bool take_all(const OctreeRunStarts& starts, std::size_t begin) noexcept {
    const std::uint32_t last = starts.count - 1, points = starts.at[last] - starts.at[0];
    if (!runs_.fit || points > most_ - runs_.points) return false;
    std::uint32_t outside = 0, longest = 0;
    for (std::uint32_t k = 0; k < last; ++k) {
      const std::uint32_t length = starts.at[k + 1] - starts.at[k];
      outside |= starts.outside[k];
      longest |= length - 1;
      pairs_.set(runs_.count + k,
                 {key(starts.part[k], length), static_cast<std::uint32_t>(begin) + starts.at[k]});
    }
    if (outside != 0 || longest >= SortedRuns::most_points) return false;
    runs_.count += last;
    runs_.points += points;
    return true;
  }
  void start(const OctreeRunStarts& starts, std::uint32_t k, std::size_t begin) noexcept {
    first_ = begin + starts.at[k];
    inside_ = starts.outside[k] == 0;
    part_ = starts.part[k];
  }
  /// The run at hand ends before point `next`.
  void end(std::size_t next) noexcept {
    if (!inside_ || !runs_.fit) return;
    const std::size_t length = next - first_;
    runs_.fit = length <= most_ - runs_.points;
    if (!runs_.fit) return;
    runs_.points += static_cast<std::uint32_t>(length);
    for (std::size_t left = length; left > 0;) {
      const std::size_t piece = left < SortedRuns::most_points ? left : SortedRuns::most_points;
      pairs_.set(runs_.count++,
                 {key(part_, static_cast<std::uint32_t>(piece)), static_cast<std::uint32_t>(next - left)});
      left -= piece;
    }
  }

  std::uint32_t most_;
  Pairs pairs_;
  Runs runs_;
  bool inside_ = false;
  std::uint32_t part_ = 0;
  std::size_t first_ = 0;
};

Runs read_runs(const PointsView& view, const OctreeGrid& grid, const OctreeKernels& kernels,
               std::uint32_t most, const Pairs& pairs) noexcept {
  RunReader reader(most, pairs);
  OctreeCellBatch cells;
  OctreeRunStarts starts;
  std::size_t inside = 0;
  while (inside < view.count && !grid.cell_of(view.at(inside), starts.first)) ++inside;
  for (std::size_t begin = 0; begin < view.count; begin += OctreeCellBatch::size) {
    const std::size_t left = view.count - begin;
    const std::size_t count = left < OctreeCellBatch::size ? left : OctreeCellBatch::size;
    cells_of(view, grid, begin, count, kernels, cells);
    kernels.starts(cells, count, starts);
    reader.read(starts, begin);
  }
  return reader.finish(starts, view.count);
}

/// Puts the next nine levels in the place of those by which the runs are in order already.
void read_part(const PointsView& view, const OctreeGrid& grid, unsigned shift, const Pairs& pairs) noexcept {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pairs::Pair run = pairs[i];
    const auto part =
        static_cast<std::uint32_t>(SortedRuns::code_at(view, grid, run.index) >> shift) & part_mask;
    pairs.set(i, {(run.key & ~part_mask) | part, run.index});
  }
}

}  // namespace

std::uint64_t SortedRuns::code_at(const PointsView& view, const OctreeGrid& grid, std::size_t i) noexcept {
  MortonCell cell;
  (void)grid.cell_of(view.at(i), cell);
  return morton_encode(cell);
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
  return {true, runs.points, one_part, runs.some_code >> SortedRuns::code_bits << SortedRuns::code_bits,
          back};
}

}  // namespace straightedge::octree
