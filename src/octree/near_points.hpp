// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

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
        loss_(squared_loss(0x1p-23 * (magnitude(from.x) + magnitude(from.y) + magnitude(from.z)))) {}

  void set_limit(double squared) noexcept {
    const double limit = raised(squared);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    limit_ = limit < 0x1p127 ? static_cast<float>(limit) : infinity;
  }

  bool all_far(const std::uint32_t* block) const noexcept { return all_far(squared(block)); }
  bool all_far(const Floats4& squares) const noexcept {
    const auto far = squares > limit_;
    std::uint64_t halves[2];
    static_assert(sizeof(halves) == sizeof(far));
    std::memcpy(halves, &far, sizeof(halves));
    return (halves[0] & halves[1]) == UINT64_MAX;
  }

  bool far(float squared) const noexcept { return squared > limit_; }

  /// The least of the squares in `count` blocks, as floats have it; `squares` has them all then.
  float least(const std::uint32_t* block, std::size_t count, Floats4* squares) const noexcept {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr std::size_t words = octree_block_points * octree_point_words;
    // Two at a time, so that one comparison need not wait for the other.
    Floats4 least{infinity, infinity, infinity, infinity};
    Floats4 other = least;
    std::size_t i = 0;
    for (; i + 2 <= count; i += 2) {
      const Floats4 here = squared(block + words * i), next = squared(block + words * (i + 1));
      squares[i] = here;
      squares[i + 1] = next;
      least = here < least ? here : least;
      other = next < other ? next : other;
    }
    if (i < count) {
      squares[i] = squared(block + words * i);
      least = squares[i] < least ? squares[i] : least;
    }
    least = other < least ? other : least;
    const float a = least[0] < least[1] ? least[0] : least[1];
    const float b = least[2] < least[3] ? least[2] : least[3];
    return a < b ? a : b;
  }
  /// A point whose square in floats is `squared` is not farther than this one.
  double not_farther_than(float squared) const noexcept { return raised(static_cast<double>(squared)); }

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
  double raised(double squared) const noexcept { return squared * (1 + 0x1p-10) + loss_; }
  static double squared_loss(double loss) noexcept { return loss * loss * (1 + 0x1p12) + 0x1p-120; }
  static double magnitude(double a) noexcept { return a < 0 ? -a : a; }

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

/// Lowers `best` to those of a block's places from `first` to `end` that are nearer.
inline bool find_nearer(std::span<const std::uint32_t> words, std::uint32_t first, std::uint32_t end,
                        const Vector3& from, OctreeNeighbour& best) noexcept {
  bool nearer = false;
  for (std::uint32_t place = first; place < end; ++place) {
    const OctreePoint p = OctreePoint::read(words, place);
    const OctreeNeighbour neighbour{p.index, squared_length(p.position() - from)};
    if (!neighbour.before(best)) continue;
    best = neighbour;
    nearer = true;
  }
  return nearer;
}

/// Lowers `best` to the nearest of the places `first` to `end`, when one of them is nearer. `filter` has the
/// limit of `best` before and after.
///
/// Floats first find how near the nearest is, without looking at any point for itself; then few are left.
/// Points of other leaves in the blocks on the border are welcome: they are in the octree, too, and bound the
/// distance.
[[gnu::always_inline]] inline void find_nearest(std::span<const std::uint32_t> words, std::uint32_t first,
                                                std::uint32_t end, const Vector3& from, FarFilter& filter,
                                                OctreeNeighbour& best) noexcept {
  constexpr auto in_block = static_cast<std::uint32_t>(octree_block_points);
  const auto last_of = [end](std::uint32_t block) { return block + in_block < end ? block + in_block : end; };
  std::uint32_t begin = first - first % in_block;
  // Of few points each is looked at as soon as it is met.
  constexpr std::uint32_t few = 16;
  if (end - first <= few) {
    bool nearer = false;
    for (; begin < end; begin += in_block) {
      if (filter.all_far(words.data() + octree_point_words * begin)) continue;
      nearer |= find_nearer(words, begin < first ? first : begin, last_of(begin), from, best);
    }
    if (nearer) filter.set_limit(best.squared_distance);
    return;
  }
  constexpr std::uint32_t at_once = 16;  // blocks
  Floats4 squares[at_once];
  for (; begin < end; begin += at_once * in_block) {
    const std::uint32_t left = (end - begin + in_block - 1) / in_block;
    const std::uint32_t count = left < at_once ? left : at_once;
    const float least = filter.least(words.data() + octree_point_words * begin, count, squares);
    if (filter.far(least)) continue;
    const double reach = filter.not_farther_than(least);
    filter.set_limit(reach < best.squared_distance ? reach : best.squared_distance);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (filter.all_far(squares[i])) continue;
      const std::uint32_t block = begin + in_block * i;
      find_nearer(words, block < first ? first : block, last_of(block), from, best);
    }
    filter.set_limit(best.squared_distance);
  }
}

}  // namespace straightedge::octree
