// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstring>

#include "octree/sort_points.hpp"

namespace straightedge::octree {

void BlockWriter::write_one(std::size_t i) noexcept {
  const Vector3 p = view_.at(i);
  OctreePoint{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
              first_index_ + static_cast<std::uint32_t>(i)}
      .write(block_, place_ % octree_block_points);
  if (++place_ % octree_block_points == 0)
    std::memcpy(&memory_[(place_ - octree_block_points) * octree_point_words], block_, sizeof(block_));
}

void BlockWriter::write_block(std::size_t first) noexcept {
  std::uint32_t* const block = &memory_[place_ * octree_point_words];
  std::memcpy(block, view_.x + first, sizeof(float) * octree_block_points);
  std::memcpy(block + 4, view_.y + first, sizeof(float) * octree_block_points);
  std::memcpy(block + 8, view_.z + first, sizeof(float) * octree_block_points);
  for (std::size_t i = 0; i < octree_block_points; ++i)
    block[12 + i] = first_index_ + static_cast<std::uint32_t>(first + i);
  place_ += octree_block_points;
}

void BlockWriter::write(std::size_t first, std::size_t end) noexcept {
  while (first < end && place_ % octree_block_points != 0) write_one(first++);
  if (view_.stride == static_cast<std::ptrdiff_t>(sizeof(float)))
    for (; end - first >= octree_block_points; first += octree_block_points) write_block(first);
  while (first < end) write_one(first++);
}

void BlockWriter::finish() noexcept {
  if (place_ % octree_block_points == 0) return;
  const std::size_t begin = place_ - place_ % octree_block_points;
  std::memcpy(&memory_[begin * octree_point_words], block_, sizeof(block_));
}

}  // namespace straightedge::octree
