// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "straightedge/octree_point.hpp"
#include "straightedge/square_root.hpp"
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
        loss_(0x1p-23 * (magnitude(from.x) + magnitude(from.y) + magnitude(from.z))) {}

  void set_limit(double squared) noexcept {
    const double raised = square_root(squared) * (1 + 0x1p-20) + loss_;
    const double limit = raised * raised + 0x1p-120;
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

  bool far(float squared) const noexcept { return squared > limit_; }

  /// The least of the squares in these blocks, as floats have it.
  float least(const std::uint32_t* block, const std::uint32_t* end) const noexcept {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr std::size_t words = octree_block_points * octree_point_words;
    // Two at a time, so that one comparison need not wait for the other.
    Floats4 least{infinity, infinity, infinity, infinity};
    Floats4 other = least;
    for (; end - block >= static_cast<std::ptrdiff_t>(2 * words); block += 2 * words) {
      const Floats4 here = squared(block), next = squared(block + words);
      least = here < least ? here : least;
      other = next < other ? next : other;
    }
    if (block != end) {
      const Floats4 here = squared(block);
      least = here < least ? here : least;
    }
    least = other < least ? other : least;
    const float a = least[0] < least[1] ? least[0] : least[1];
    const float b = least[2] < least[3] ? least[2] : least[3];
    return a < b ? a : b;
  }
  /// A point whose square in floats is `squared` is not farther than this one.
  double not_farther_than(float squared) const noexcept {
    const double raised = square_root(static_cast<double>(squared)) * (1 + 0x1p-20) + loss_;
    return raised * raised + 0x1p-120;
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
  static double magnitude(double a) noexcept { return a < 0 ? -a : a; }

  float x_, y_, z_;
  float limit_ = 0;
  double loss_;
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

/// Lowers `best` to the nearest of the places `first` to `end`, when one of them is nearer. `filter` has the
/// limit of `best` before and after.
///
/// Floats first find how near the nearest is, without looking at any point for itself; then few are left.
/// Points of other leaves in the blocks on the border are welcome: they are in the octree, too, and bound the
/// distance.
inline void find_nearest(std::span<const std::uint32_t> words, std::uint32_t first, std::uint32_t end,
                         const Vector3& from, FarFilter& filter, OctreeNeighbour& best) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  const std::uint32_t begin = first - first % in_block;
  const std::uint32_t* const blocks = words.data();
  // Of few points each is looked at as soon as it is met.
  constexpr std::uint32_t few = 16;
  if (end - first > few) {
    const float least = filter.least(blocks + octree_point_words * begin,
                                     blocks + octree_point_words * octree_full_blocks(end));
    if (filter.far(least)) return;
    const double reach = filter.not_farther_than(least);
    filter.set_limit(reach < best.squared_distance ? reach : best.squared_distance);
  }
  bool nearer = false;
  for (std::uint32_t block = begin; block < end; block += in_block) {
    if (filter.all_far(blocks + octree_point_words * block)) continue;
    const std::uint32_t last = block + in_block < end ? block + in_block : end;
    for (std::uint32_t place = block < first ? first : block; place < last; ++place) {
      const OctreePoint p = OctreePoint::read(words, place);
      const OctreeNeighbour neighbour{p.index, squared_length(p.position() - from)};
      if (!neighbour.before(best)) continue;
      best = neighbour;
      nearer = true;
    }
  }
  if (nearer || end - first > few) filter.set_limit(best.squared_distance);
}

}  // namespace straightedge::octree
