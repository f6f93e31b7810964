// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "base/lowest_bit.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/octree_point.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge::octree {

// Four numbers that are treated alike; the bits do not depend on how many a processor takes at once.
using Floats4 = float __attribute__((vector_size(16)));

/// Tells in floats, four points at a time, which points are certainly too far; the others are looked at in
/// doubles.
///
/// A coordinate of the position loses at most 2^-24 of itself as a float, and a float sum of three squares of
/// differences errs by less than 2^-20 of its value; the limit is raised by more than both.
class FarFilter {
 public:
  explicit FarFilter(const Vector3& from) noexcept
      : x_(static_cast<float>(from.x)),
        y_(static_cast<float>(from.y)),
        z_(static_cast<float>(from.z)),
        loss_(squared_loss(0x1p-23 *
                           (__builtin_fabs(from.x) + __builtin_fabs(from.y) + __builtin_fabs(from.z)))) {}

  void set_limit(double squared) noexcept {
    const double limit = raised(squared);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    limit_ = limit < 0x1p127 ? static_cast<float>(limit) : infinity;
  }

  bool all_far(const std::uint32_t* block) const noexcept {
    const auto far = squared(block) > limit_;
    std::uint64_t halves[2];
    static_assert(sizeof(halves) == sizeof(far));
    std::memcpy(halves, &far, sizeof(halves));
    return (halves[0] & halves[1]) == UINT64_MAX;
  }

  OctreeNearTask near_task(const std::uint32_t* blocks, std::uint32_t count) const noexcept {
    return {blocks, count, x_, y_, z_, limit_, slack, loss_};
  }

 private:
  Floats4 squared(const std::uint32_t* block) const noexcept {
    Floats4 x, y, z;
    std::memcpy(&x, block, sizeof(x));
    std::memcpy(&y, block + 4, sizeof(y));
    std::memcpy(&z, block + 8, sizeof(z));
    x -= x_;
    y -= y_;
    z -= z_;
    return x * x + y * y + z * z;
  }
  /// At least (s + loss)² for a squared distance s², without a root: 2 s loss is at most s² / 2^11 + 2^11
  /// loss².
  double raised(double squared) const noexcept { return squared * slack + loss_; }
  static double squared_loss(double loss) noexcept { return loss * loss * (1 + 0x1p12) + 0x1p-120; }

  static constexpr double slack = 1 + 0x1p-10;

  float x_, y_, z_;
  float limit_ = 0;
  double loss_;  ///< squared
};

/// Calls take(neighbour) for those of the places `first` to `end` that are not farther than `limit`, which
/// `take` may lower. Blocks on the border of the range have points of other leaves.
template <class Take>
void for_near_points(std::span<const std::uint32_t> words, std::uint32_t first, std::uint32_t end,
                     const Vector3& from, const double& limit, Take take) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  FarFilter filter(from);
  filter.set_limit(limit);
  for (std::uint32_t begin = first - first % in_block; begin < end; begin += in_block) {
    if (filter.all_far(words.data() + octree_point_words * begin)) continue;
    const std::uint32_t last = begin + in_block < end ? begin + in_block : end;
    for (std::uint32_t place = begin < first ? first : begin; place < last; ++place) {
      const OctreePoint p = OctreePoint::read(words, place);
      const double squared = squared_length(p.position() - from);
      if (squared <= limit) take(OctreeNeighbour{p.index, squared});
    }
    filter.set_limit(limit);
  }
}

/// Lowers `best` to the point at a place, if that is nearer.
[[gnu::always_inline]] inline void take_nearer(std::span<const std::uint32_t> words, std::uint32_t place,
                                               const Vector3& from, OctreeNeighbour& best) noexcept {
  const OctreePoint p = OctreePoint::read(words, place);
  const OctreeNeighbour neighbour{p.index, squared_length(p.position() - from)};
  if (neighbour.before(best)) best = neighbour;
}

/// Lowers `best` to the nearest of the places `first` to `end`, when one of them is nearer. `filter` has the
/// limit of `best` before and after.
///
/// Floats tell which points can be: few, mostly one. Points of other leaves in the blocks on the border are
/// welcome: they are in the octree, too, and bound the distance.
[[gnu::always_inline]] inline void find_nearest(const OctreeKernels& kernels,
                                                std::span<const std::uint32_t> words, std::uint32_t first,
                                                std::uint32_t end, const Vector3& from, FarFilter& filter,
                                                OctreeNeighbour& best) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  const std::uint32_t begin = first - first % in_block;
  constexpr std::uint32_t at_once = OctreeNearTask::most_blocks;
  for (std::uint32_t start = begin; start < end; start += at_once * in_block) {
    const std::uint32_t left = (end - start + in_block - 1) / in_block;
    std::uint64_t near = kernels.near(
        filter.near_task(words.data() + octree_point_words * start, left < at_once ? left : at_once));
    for (; near != 0; near &= near - 1) take_nearer(words, start + detail::lowest_bit(near), from, best);
    filter.set_limit(best.squared_distance);
  }
}

}  // namespace straightedge::octree
