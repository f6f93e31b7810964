// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include "octree/groups_around.hpp"
#include "octree/lanes.hpp"
#include "octree/node_distance.hpp"
#include "straightedge/detail/octree_leaf_groups.hpp"

namespace straightedge::octree {

// Eight numbers that are treated alike.
using Shorts8 = std::int16_t __attribute__((vector_size(16)));
using Words8 = std::uint16_t __attribute__((vector_size(16)));
using Bytes16 = unsigned char __attribute__((vector_size(16)));

constexpr Shorts8 lanes8{0, 1, 2, 3, 4, 5, 6, 7};

inline Shorts8 all(std::int16_t v) noexcept {
  return Shorts8{v, v, v, v, v, v, v, v};
}
inline Shorts8 least(const Shorts8& a, const Shorts8& b) noexcept {
  return a < b ? a : b;
}
inline Shorts8 greatest(const Shorts8& a, const Shorts8& b) noexcept {
  return a > b ? a : b;
}

/// How near to a position the boxes of a group's leaves are, squared, in units of boxes: whole numbers of 16
/// bits, eight at a time, counted from -32768 on, since processors compare signed ones best.
///
/// The position is known by its unit alone; so a gap is never longer than it is, but for what doubles lose:
/// less than 2^-18 of a unit, which makes less than one of a square. Longer gaps than `most_gap` are cut, so
/// that three squares fit in 16 bits; what is so far away is not looked for here.
class BoxSquares {
 public:
  static constexpr std::int16_t none = INT16_MAX;  ///< no leaf; farther than every limit

  BoxSquares(std::int16_t x, std::int16_t y, std::int16_t z) noexcept
      : after_{all(x) + 1, all(y) + 1, all(z) + 1} {}

  Shorts8 of(const unsigned char* block) const noexcept {
    Bytes16 corners[3];  // lowest x, y; lowest z, highest x; highest y, z
    std::memcpy(corners, block, sizeof(corners));
    Words8 sum = squared(front(corners[0]) - after_[0], after_[0] - back(corners[1]));
    sum += squared(back(corners[0]) - after_[1], after_[1] - front(corners[2]));
    sum += squared(front(corners[1]) - after_[2], after_[2] - back(corners[2]));
    sum ^= 0x8000;
    return reinterpret_cast<const Shorts8&>(sum);
  }
  /// What the square of a leaf that may be so near is at most.
  static std::int32_t limit_of(double squared_units) noexcept {
    constexpr double last = 65533;
    return static_cast<std::int32_t>(squared_units < last ? squared_units + 1 : last + 1) - 32768;
  }

 private:
  static constexpr std::int16_t most_gap = 147;

  /// Of the distances below the lowest and above the highest unit, two too long.
  static Words8 squared(const Shorts8& below, const Shorts8& above) noexcept {
    const Shorts8 gap = least(greatest(greatest(below, above - 2), all(0)), all(most_gap));
    const auto length = reinterpret_cast<const Words8&>(gap);
    return length * length;
  }
  static Shorts8 front(const Bytes16& v) noexcept {
    const Bytes16 pairs =
        little_endian
            ? __builtin_shufflevector(v, Bytes16{}, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23)
            : __builtin_shufflevector(v, Bytes16{}, 16, 0, 17, 1, 18, 2, 19, 3, 20, 4, 21, 5, 22, 6, 23, 7);
    return reinterpret_cast<const Shorts8&>(pairs);
  }
  static Shorts8 back(const Bytes16& v) noexcept {
    const Bytes16 pairs = little_endian ? __builtin_shufflevector(v, Bytes16{}, 8, 24, 9, 25, 10, 26, 11, 27,
                                                                  12, 28, 13, 29, 14, 30, 15, 31)
                                        : __builtin_shufflevector(v, Bytes16{}, 24, 8, 25, 9, 26, 10, 27, 11,
                                                                  28, 12, 29, 13, 30, 14, 31, 15);
    return reinterpret_cast<const Shorts8&>(pairs);
  }

  Shorts8 after_[3];  ///< the unit behind the position's
};

/// The least of eight.
inline std::int32_t least_of(const Shorts8& v) noexcept {
  Shorts8 turned = __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  Shorts8 least = v < turned ? v : turned;
  turned = __builtin_shufflevector(least, least, 2, 3, 0, 1, 6, 7, 4, 5);
  least = least < turned ? least : turned;
  return least[0] < least[1] ? least[0] : least[1];
}

/// Calls look(first, end) for the points of a group's leaves, the nearest leaf first, that are not farther
/// than the limit that it returns. Says the limit.
template <class Look>
[[gnu::always_inline]] inline double look_through_group(const detail::OctreeLeafGroups& groups,
                                                        std::uint32_t group, const BoxSquares& distance,
                                                        double square_units_a_m, double limit,
                                                        Look look) noexcept {
  using Groups = detail::OctreeLeafGroups;
  constexpr auto in_block = Groups::in_block;
  const std::uint32_t first = groups.first[group], end = groups.first[group + 1];
  const std::uint32_t start = first - first % in_block;  // the first lane's leaf
  // Asked for when all boxes have been looked at.
  __builtin_prefetch(&groups.place[first]);
  const unsigned char* block = &groups.boxes[first / in_block * Groups::block_bytes];
  const Shorts8 begin = all(static_cast<std::int16_t>(first - start));
  const Shorts8 past = all(static_cast<std::int16_t>(end - start));
  Shorts8 squares[Groups::most_leaves / in_block + 1];
  Shorts8 nearest = all(BoxSquares::none), next = nearest;
  std::uint32_t lanes = 0;
  for (; lanes < end - start; lanes += in_block, block += Groups::block_bytes) {
    const Shorts8 lane = lanes8 + static_cast<std::int16_t>(lanes);
    const Shorts8 mine = (lane >= begin) & (lane < past);
    const Shorts8 here = greatest(distance.of(block), mine ^ BoxSquares::none);
    squares[lanes / in_block] = here;
    next = least(next, greatest(nearest, here));
    nearest = least(nearest, here);
  }
  const std::int32_t least = least_of(nearest);
  std::int32_t farthest = BoxSquares::limit_of(limit * square_units_a_m);
  if (least > farthest) return limit;
  const auto look_at = [&](std::uint32_t lane) {
    limit = look(groups.place[start + lane], groups.place[start + lane + 1]);
    farthest = BoxSquares::limit_of(limit * square_units_a_m);
  };
  std::uint32_t seen = 0;
  while (!Lanes(squares[seen / in_block] == static_cast<std::int16_t>(least)).any()) seen += in_block;
  seen += Lanes(squares[seen / in_block] == static_cast<std::int16_t>(least)).take();
  look_at(seen);
  for (std::uint32_t i = 0; i < lanes; i += in_block) {
    for (Lanes near(squares[i / in_block] <= static_cast<std::int16_t>(farthest)); near.any();) {
      const std::uint32_t lane = near.take();
      if (i + lane != seen && squares[i / in_block][lane] <= farthest) look_at(i + lane);
    }
  }
  return limit;
}

/// How far away the other side of a border is, and a bit for its axis.
struct Border {
  double squared;
  std::uint32_t axis;
};

/// Without a branch: which is nearer is anybody's guess.
inline void put_in_order(Border& low, Border& high) noexcept {
  const std::uint32_t turned = (low.axis ^ high.axis) & (high.squared < low.squared ? UINT32_MAX : 0);
  const double least = high.squared < low.squared ? high.squared : low.squared;
  high.squared = high.squared < low.squared ? low.squared : high.squared;
  low.squared = least;
  low.axis ^= turned;
  high.axis ^= turned;
}

/// The same for the groups around the position.
template <class Look>
double look_around(const detail::OctreeLeafGroups& groups, const GroupsAround& around,
                   const NodeDistance& distance, double limit, Look look) noexcept {
  const double square_units_a_m = distance.squares_a_m(detail::OctreeLeafGroups::units_a_cell);
  Border a{distance.squared(around.gap(0)), 1}, b{distance.squared(around.gap(1)), 2},
      c{distance.squared(around.gap(2)), 4};
  put_in_order(a, b);
  put_in_order(b, c);
  put_in_order(a, b);
  // Whatever follows b, and a + b, is not nearer than it is.
  const double squares[] = {0,
                            a.squared,
                            b.squared,
                            c.squared,
                            a.squared + b.squared,
                            a.squared + c.squared,
                            b.squared + c.squared,
                            a.squared + b.squared + c.squared};
  const std::uint32_t axes[] = {0, a.axis, b.axis, c.axis, a.axis | b.axis, a.axis | c.axis, b.axis | c.axis,
                                7};
  for (std::uint32_t i = 0; i < 8; ++i) {
    if (squares[i] > limit) {
      if (i == 3) continue;
      break;
    }
    const std::uint32_t octant = around.home() ^ axes[i];
    const std::uint32_t group = groups.find(around.address(octant));
    if (group == groups.groups) continue;
    const BoxSquares boxes(around.unit(octant, 0), around.unit(octant, 1), around.unit(octant, 2));
    limit = look_through_group(groups, group, boxes, square_units_a_m, limit, look);
  }
  return limit;
}

}  // namespace straightedge::octree
