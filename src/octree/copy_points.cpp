// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>

#include "octree/sort_points.hpp"

namespace straightedge::octree {
namespace {

// Four words that are treated alike, as in near_points.hpp.
using Words4 = std::uint32_t __attribute__((vector_size(16)));

constexpr Words4 lanes{0, 1, 2, 3};

/// Writes the lanes from `lane` on.
void put(std::uint32_t* to, const Words4& from, std::uint32_t lane) noexcept {
  Words4 there;
  std::memcpy(&there, to, sizeof(there));
  const auto mine = lanes >= lane;
  const Words4 both = mine ? from : there;
  std::memcpy(to, &both, sizeof(both));
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
         end + octree_block_points <= view_.count;
}

void BlockWriter::write(std::size_t first, std::size_t end) noexcept {
  if (!readable(first, end)) {
    while (first < end) write_one(first++);
    return;
  }
  const auto count = static_cast<std::uint32_t>(end - first);
  std::uint32_t lane = place_ % octree_block_points;
  // The point that the block's first lane would hold.
  std::size_t from = first - lane;
  std::uint32_t* block = &memory_[(place_ - lane) * octree_point_words];
  for (; from < end; from += octree_block_points, block += octree_block_points * octree_point_words) {
    put(block, four_of(view_.x, from), lane);
    put(block + 4, four_of(view_.y, from), lane);
    put(block + 8, four_of(view_.z, from), lane);
    put(block + 12, first_index_ + static_cast<std::uint32_t>(from) + lanes, lane);
    lane = 0;
  }
  place_ += count;
}

}  // namespace straightedge::octree
