// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "octree/sort_points.hpp"

namespace straightedge::octree {

/// Points that are written one after another. A block is written whole, up to three places too far.
class BlockWriter {
 public:
  BlockWriter(const PointsView& view, std::uint32_t first_index, std::span<std::uint32_t> memory) noexcept
      : view_(view), first_index_(first_index), memory_(memory) {
    constexpr std::size_t around = 2 * octree_block_points;
    if (view.stride == static_cast<std::ptrdiff_t>(sizeof(float)) && view.count > around)
      blocks_end_ = view.count - around;
  }

  std::uint32_t place() const noexcept { return place_; }
  /// Asks for point i, which will be written soon: runs lie anywhere in the view.
  void prefetch(std::size_t i) const noexcept {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * view_.stride;
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.x) + offset);
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.y) + offset);
    __builtin_prefetch(reinterpret_cast<const unsigned char*>(view_.z) + offset);
  }
  /// Points `first` to `end` of the view.
  void write(std::size_t first, std::size_t end) noexcept {
    if (first >= octree_block_points && end <= blocks_end_) {
      write_blocks(first, end);
    } else {
      while (first < end) write_one(first++);
    }
  }

 private:
  // Four words that are treated alike, as in near_kernel.cpp.
  using Words4 = std::uint32_t __attribute__((vector_size(16)));

  static constexpr std::uint32_t all = UINT32_MAX;
  static constexpr Words4 first_lanes[] = {
      {all, all, all, all}, {0, all, all, all}, {0, 0, all, all}, {0, 0, 0, all}};

  static Words4 four_of(const float* coordinates, std::size_t i) noexcept {
    Words4 four;
    std::memcpy(&four, coordinates + i, sizeof(four));
    return four;
  }
  /// Writes the lanes that are `mine`.
  static void put(std::uint32_t* to, const Words4& from, const Words4& mine) noexcept {
    Words4 there;
    std::memcpy(&there, to, sizeof(there));
    put(to, (from & mine) | (there & ~mine));
  }
  static void put(std::uint32_t* to, const Words4& from) noexcept { std::memcpy(to, &from, sizeof(from)); }

  void write_one(std::size_t i) noexcept {
    const Vector3 p = view_.at(i);
    OctreePoint{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                first_index_ + static_cast<std::uint32_t>(i)}
        .write(memory_, place_++);
  }
  void write_blocks(std::size_t first, std::size_t end) noexcept {
    const std::uint32_t lane = place_ % octree_block_points;
    // The point that the block's first lane would hold.
    std::size_t from = first - lane;
    std::uint32_t* block = &memory_[(place_ - lane) * octree_point_words];
    Words4 index = Words4{0, 1, 2, 3} + (first_index_ + static_cast<std::uint32_t>(from));
    const Words4 mine = first_lanes[lane];
    put(block, four_of(view_.x, from), mine);
    put(block + 4, four_of(view_.y, from), mine);
    put(block + 8, four_of(view_.z, from), mine);
    put(block + 12, index, mine);
    // Most runs end in the next block: whether they do not is hard to foresee, and it may be written in any
    // case.
    do {
      from += octree_block_points;
      block += octree_block_points * octree_point_words;
      index += static_cast<std::uint32_t>(octree_block_points);
      put(block, four_of(view_.x, from));
      put(block + 4, four_of(view_.y, from));
      put(block + 8, four_of(view_.z, from));
      put(block + 12, index);
    } while (from + octree_block_points < end);
    place_ += static_cast<std::uint32_t>(end - first);
  }

  PointsView view_;
  std::size_t blocks_end_ = 0;  ///< before it and from the second block on, whole ones around can be read
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
