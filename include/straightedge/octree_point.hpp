// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/status.hpp"
#include "straightedge/vector3.hpp"

/// What an octree keeps of a point, and what its queries answer.
namespace straightedge {

/// Values of a digit by which the octree sorts.
inline constexpr std::size_t octree_sort_values = 2048;

/// Points are kept in blocks of four: four x, four y, four z, four indices, so that compilers look at several
/// at once. All are words of 32 bits, because the same memory holds pairs of sort key and index while points
/// are sorted.
inline constexpr std::size_t octree_block_points = 4;
inline constexpr std::size_t octree_point_words = 4;

/// Points up to the next full block.
constexpr std::size_t octree_full_blocks(std::size_t points) noexcept {
  return (points + octree_block_points - 1) / octree_block_points * octree_block_points;
}

/// Places behind those of the points: the blocks of what is inserted begin anew, and points are written by
/// blocks.
inline constexpr std::size_t octree_spare_points = 12;

/// A point with its index in the order in which points were given.
struct OctreePoint {
  float x = 0, y = 0, z = 0;
  std::uint32_t index = 0;

  constexpr bool operator==(const OctreePoint&) const noexcept = default;

  Vector3 position() const noexcept {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
  static OctreePoint read(std::span<const std::uint32_t> words, std::size_t place) noexcept {
    const std::size_t at = word_of(place);
    return {std::bit_cast<float>(words[at]), std::bit_cast<float>(words[at + 4]),
            std::bit_cast<float>(words[at + 8]), words[at + 12]};
  }
  void write(std::span<std::uint32_t> words, std::size_t place) const noexcept {
    const std::size_t at = word_of(place);
    words[at] = std::bit_cast<std::uint32_t>(x);
    words[at + 4] = std::bit_cast<std::uint32_t>(y);
    words[at + 8] = std::bit_cast<std::uint32_t>(z);
    words[at + 12] = index;
  }

 private:
  static constexpr std::size_t word_of(std::size_t place) noexcept {
    return place / octree_block_points * octree_block_points * octree_point_words +
           place % octree_block_points;
  }
};

struct OctreeNeighbour {
  std::uint32_t index = 0;      ///< in the order in which points were given
  double squared_distance = 0;  ///< m²

  constexpr bool operator==(const OctreeNeighbour&) const noexcept = default;
  /// Nearer; of equal distances the lower index.
  constexpr bool before(const OctreeNeighbour& other) const noexcept {
    return squared_distance < other.squared_distance ||
           (squared_distance == other.squared_distance && index < other.index);
  }
};

/// What every query says.
struct OctreeFound {
  Status status = Status::not_prepared;
  std::uint32_t found = 0;    ///< of points or leaves; all of them, also when `out` was full
  std::uint32_t written = 0;  ///< elements of `out` that were filled
};

}  // namespace straightedge
