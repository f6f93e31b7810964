// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "straightedge/octree_point.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge::octree {

// Four numbers that are treated alike; the bits do not depend on how many a processor takes at once.
using Floats4 = float __attribute__((vector_size(16)));
using Doubles4 = double __attribute__((vector_size(32)));

/// What compilers make of this are as many conversions, differences and products at once as there are.
inline void block_distances(const std::uint32_t* block, const Vector3& from, Doubles4& squared) noexcept {
  Floats4 x, y, z;
  std::memcpy(&x, block, sizeof(x));
  std::memcpy(&y, block + 4, sizeof(y));
  std::memcpy(&z, block + 8, sizeof(z));
  const Doubles4 dx = __builtin_convertvector(x, Doubles4) - from.x;
  const Doubles4 dy = __builtin_convertvector(y, Doubles4) - from.y;
  const Doubles4 dz = __builtin_convertvector(z, Doubles4) - from.z;
  squared = dx * dx + dy * dy + dz * dz;
}

/// Calls take(neighbour) for those of the places `first` to `end` that are not farther than `limit`, which
/// `take` may lower. Blocks on the border of the range have points of other leaves.
template <class Take>
void for_near_points(std::span<const std::uint32_t> words, std::uint32_t first, std::uint32_t end,
                     const Vector3& from, const double& limit, Take take) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  for (std::uint32_t begin = first - first % in_block; begin < end; begin += in_block) {
    const std::uint32_t* block = words.data() + octree_point_words * begin;
    Doubles4 squared;
    block_distances(block, from, squared);
    if (squared[0] > limit && squared[1] > limit && squared[2] > limit && squared[3] > limit) continue;
    for (std::uint32_t i = 0; i < in_block; ++i) {
      const std::uint32_t place = begin + i;
      if (place >= first && place < end && squared[i] <= limit)
        take(OctreeNeighbour{block[12 + i], squared[i]});
    }
  }
}

}  // namespace straightedge::octree
