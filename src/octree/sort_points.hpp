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
  static constexpr std::uint32_t most_points = std::uint32_t{1} << (32 - code_bits);

  bool fit = false;          ///< false: there are more points in the cube than may be
  std::uint32_t points = 0;  ///< in the cube
  bool one_part = true;      ///< codes differ within the nine lowest levels alone
  std::uint64_t above = 0;   ///< the part of the code above them, if so
  Pairs pairs;               ///< at the end of the memory that so many points take, and three more

  static std::uint32_t length(std::uint32_t key) noexcept { return (key >> code_bits) + 1; }
  std::uint64_t code(const Pairs::Pair& run, const PointsView& view, const OctreeGrid& grid) const noexcept;
};

/// Steps 1 and 2, in memory for `most` points and octree_spare_points.
SortedRuns sort_runs(const PointsView& view, const OctreeGrid& grid, const OctreeKernels& kernels,
                     std::uint32_t most, std::span<std::uint32_t> memory,
                     std::span<std::uint32_t> counts) noexcept;

/// Points that are written one after another. A block is written whole, up to three places too far.
class BlockWriter {
 public:
  BlockWriter(const PointsView& view, std::uint32_t first_index, std::span<std::uint32_t> memory) noexcept
      : view_(view), first_index_(first_index), memory_(memory) {}

  std::uint32_t place() const noexcept { return place_; }
  /// Asks for point i, which will be written soon: runs lie anywhere in the view.
  void prefetch(std::size_t i) const noexcept {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * view_.stride;
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.x) + offset);
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.y) + offset);
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.z) + offset);
  }
  /// Points `first` to `end` of the view.
  void write(std::size_t first, std::size_t end) noexcept;

 private:
  bool readable(std::size_t first, std::size_t end) const noexcept;
  void write_one(std::size_t i) noexcept;

  PointsView view_;
  std::uint32_t first_index_;
  std::span<std::uint32_t> memory_;
  std::uint32_t place_ = 0;
};

/// Step 3: copies the points of the runs to the start of the same memory and calls leaf(code, place) for the
/// first point of each cell. Each run that waits has a point and takes half of its room, and stands three
/// places behind it: no run is written over before it has been read.
template <class Leaf>
void copy_points(const SortedRuns& runs, const PointsView& view, const OctreeGrid& grid,
                 std::uint32_t first_index, std::span<std::uint32_t> memory, Leaf leaf) noexcept {
  BlockWriter writer(view, first_index, memory);
  std::uint64_t last = morton_codes;
  for (std::size_t i = 0; i < runs.pairs.size(); ++i) {
    const Pairs::Pair run = runs.pairs[i];
    constexpr std::size_t ahead = 48;
    if (i + ahead < runs.pairs.size()) writer.prefetch(runs.pairs[i + ahead].index);
    const std::uint64_t code = runs.code(run, view, grid);
    if (code != last) leaf(code, writer.place());
    last = code;
    writer.write(run.index, run.index + std::size_t{SortedRuns::length(run.key)});
  }
}

}  // namespace straightedge::octree
