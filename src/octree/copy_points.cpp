// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>

#include "octree/sort_points.hpp"

namespace straightedge::octree {
namespace {

// Four words that are treated alike, as in near_points.hpp.
using Words4 = std::uint32_t __attribute__((vector_size(16)));

constexpr Words4 lanes{0, 1, 2, 3};
constexpr std::uint32_t all = UINT32_MAX;
constexpr Words4 first_lanes[] = {{all, all, all, all}, {0, all, all, all}, {0, 0, all, all}, {0, 0, 0, all}};

/// Writes the lanes that are `mine`.
void put(std::uint32_t* to, const Words4& from, const Words4& mine) noexcept {
  Words4 there;
  std::memcpy(&there, to, sizeof(there));
  const Words4 both = (from & mine) | (there & ~mine);
  std::memcpy(to, &both, sizeof(both));
}
void put(std::uint32_t* to, const Words4& from) noexcept {
  std::memcpy(to, &from, sizeof(from));
}

Words4 four_of(const float* coordinates, std::size_t i) noexcept {
  Words4 four;
  std::memcpy(&four, coordinates + i, sizeof(four));
  return four;
}

}  // namespace

void BlockWriter::write_one(std::size_t i) noexcept {
  const Vector3 p = view_.at(i);
  OctreePoint{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
              first_index_ + static_cast<std::uint32_t>(i)}
      .write(memory_, place_++);
}

/// Whether whole blocks can be read around the points.
bool BlockWriter::readable(std::size_t first, std::size_t end) const noexcept {
  return view_.stride == static_cast<std::ptrdiff_t>(sizeof(float)) && first >= octree_block_points &&
         end + 2 * octree_block_points <= view_.count;
}

void BlockWriter::write(std::size_t first, std::size_t end) noexcept {
  if (!readable(first, end)) {
    while (first < end) write_one(first++);
    return;
  }
  const auto count = static_cast<std::uint32_t>(end - first);
  const std::uint32_t lane = place_ % octree_block_points;
  // The point that the block's first lane would hold.
  std::size_t from = first - lane;
  std::uint32_t* block = &memory_[(place_ - lane) * octree_point_words];
  Words4 index = lanes + (first_index_ + static_cast<std::uint32_t>(from));
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
  place_ += count;
}

}  // namespace straightedge::octree
