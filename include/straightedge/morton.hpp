// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

/// Morton codes: one number for a cell of a cubic grid, so that cells which are near one another mostly have
/// numbers that are.
///
///   1. Spread the bits of x, y and z to every third place.
///   2. Interleave: code = ... z1 y1 x1 z0 y0 x0. From the top, every three bits choose one of eight octants.
///   3. So cells of one octree node follow one another in the order of codes: the ancestor `level` levels
///      up is the code without its lowest 3 * level bits.
///   4. A neighbour is found in the code itself: the bits of one axis are counted up or down while those of
///      the others are filled so that they pass the carry on.
///
/// G. M. Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing", IBM
/// Ltd., Ottawa, 1966. G. Schrack, "Finding Neighbors of Equal Size in Linear Quadtrees and Octrees in
/// Constant Time", CVGIP: Image Understanding 55(3), 1992, doi:10.1016/1049-9660(92)90022-U (step 4).
///
/// Integers alone; no errors: higher bits of coordinates and codes than the 21 and 63 are not looked at.
namespace straightedge {

inline constexpr int morton_levels = 21;  ///< bits an axis; the whole grid is the one node of this level
inline constexpr std::uint32_t morton_side = std::uint32_t{1} << 21U;   ///< cells along an axis
inline constexpr std::uint64_t morton_codes = std::uint64_t{1} << 63U;  ///< every code is below
inline constexpr std::uint64_t morton_x_bits = 0x1249'2492'4924'9249;   ///< those of y one to the left

/// A cell of the finest level; each coordinate is below `morton_side`.
struct MortonCell {
  std::uint32_t x = 0, y = 0, z = 0;

  constexpr bool operator==(const MortonCell&) const noexcept = default;
};

/// Step 1: bit i to bit 3 i.
constexpr std::uint64_t morton_spread(std::uint32_t value) noexcept {
  std::uint64_t v = value & (morton_side - 1);
  v = (v | (v << 32U)) & 0x001f'0000'0000'ffff;
  v = (v | (v << 16U)) & 0x001f'0000'ff00'00ff;
  v = (v | (v << 8U)) & 0x100f'00f0'0f00'f00f;
  v = (v | (v << 4U)) & 0x10c3'0c30'c30c'30c3;
  return (v | (v << 2U)) & morton_x_bits;
}

/// Step 1 backwards; bits between are dropped.
constexpr std::uint32_t morton_gather(std::uint64_t v) noexcept {
  v &= morton_x_bits;
  v = (v | (v >> 2U)) & 0x10c3'0c30'c30c'30c3;
  v = (v | (v >> 4U)) & 0x100f'00f0'0f00'f00f;
  v = (v | (v >> 8U)) & 0x001f'0000'ff00'00ff;
  v = (v | (v >> 16U)) & 0x001f'0000'0000'ffff;
  return static_cast<std::uint32_t>((v | (v >> 32U)) & (morton_side - 1));
}

/// Step 2.
constexpr std::uint64_t morton_encode(const MortonCell& cell) noexcept {
  return morton_spread(cell.x) | (morton_spread(cell.y) << 1U) | (morton_spread(cell.z) << 2U);
}
constexpr MortonCell morton_decode(std::uint64_t code) noexcept {
  return {morton_gather(code), morton_gather(code >> 1U), morton_gather(code >> 2U)};
}

/// Step 3: the first code of the node that lies `level` (0 to 21) levels above the cell.
constexpr std::uint64_t morton_ancestor(std::uint64_t code, int level) noexcept {
  return code >> static_cast<unsigned>(3 * level) << static_cast<unsigned>(3 * level);
}
/// The lowest level at which both cells lie in one node; 0 when they are the same cell.
constexpr int morton_common_level(std::uint64_t a, std::uint64_t b) noexcept {
  return (64 - std::countl_zero(a ^ b) + 2) / 3;
}

struct MortonNeighbour {
  bool inside = false;  ///< false: the step leaves the grid, and `code` means nothing
  std::uint64_t code = 0;
};

/// Step 4: the node of the same level (0 to 20) that lies dx, dy, dz (each -1, 0 or 1) nodes away.
constexpr MortonNeighbour morton_neighbour(std::uint64_t code, int level, int dx, int dy, int dz) noexcept {
  const int steps[] = {dx, dy, dz};
  code = morton_ancestor(code, level);
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t mask = morton_ancestor(morton_x_bits << static_cast<unsigned>(axis), level);
    const std::uint64_t one = std::uint64_t{1} << static_cast<unsigned>(3 * level + axis);
    const std::uint64_t bits = code & mask;
    if (steps[axis] == 0) continue;
    if (bits == (steps[axis] > 0 ? mask : 0)) return {};
    const std::uint64_t moved = steps[axis] > 0 ? (bits | ~mask) + one : bits - one;
    code = (code & ~mask) | (moved & mask);
  }
  return {true, code};
}

}  // namespace straightedge
