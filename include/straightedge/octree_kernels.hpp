// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/morton.hpp"

/// The inner loops of Octree::build and Octree::nearest (octree.hpp) over points that follow one another, as
/// a table. The plain table is always there; others give the same bits with more instructions. Which of them
/// this machine can run, the application must know (host/kernels.hpp asks the processor): a table's functions
/// stop a program that has not the instructions.
namespace straightedge {

/// One axis of an octree's cells: cell = floor((x - origin) * scale + offset), from 0 to below `end`.
struct OctreeAxis {
  double origin = 0, scale = 1, offset = 0, end = 0;
};

/// Cells of points that follow one another, an axis at a time, so that processors take several points at
/// once.
struct OctreeCellBatch {
  static constexpr std::size_t size = 64;

  /// Element 0 is the last point of the batch before; an axis on which a point is outside the cube or not a
  /// number is -1, and so is every axis before the first point.
  std::int32_t x[size + 1], y[size + 1], z[size + 1];

  OctreeCellBatch() noexcept { x[size] = y[size] = z[size] = -1; }
};

/// Where runs of points begin that share a cell.
struct OctreeRunStarts {
  std::uint32_t count = 0;                       ///< in the batch
  std::uint32_t at[OctreeCellBatch::size];       ///< places in the batch, ascending
  std::uint32_t part[OctreeCellBatch::size];     ///< of the Morton code, its nine lowest levels
  std::uint32_t outside[OctreeCellBatch::size];  ///< 1: an axis of the cell is -1

  /// A cell in the cube, which the others there are compared with.
  MortonCell first;
  std::uint32_t part_differs = 0;  ///< bits in which any of their parts has differed from its part so far
  std::uint32_t cell_differs = 0;  ///< and any of their coordinates, along whichever axis, from its own
};

/// Which points of a leaf may be the nearest to a position.
struct OctreeNearTask {
  static constexpr std::uint32_t most_blocks = 16;

  const std::uint32_t* blocks = nullptr;  ///< of points, as octree_point.hpp has them
  std::uint32_t count = 0;                ///< of blocks, from 1 to `most_blocks`
  float x = 0, y = 0, z = 0;              ///< the position
  float limit = 0;                        ///< what is farther, squared, is not asked for
  double slack = 0, loss = 0;  ///< up to least · slack + loss a point may be nearer than the least
};

struct OctreeKernels {
  /// Cells of coordinates; -1 for one that is outside or not a number.
  void (*cells)(const float* coordinates, std::size_t count, const OctreeAxis& axis,
                std::int32_t* cells) noexcept;
  /// Of the first `points` of a batch those that are in another cell than the one before. Only the last batch
  /// has fewer than its size.
  void (*starts)(const OctreeCellBatch& cells, std::size_t points, OctreeRunStarts& starts) noexcept;
  /// A bit for each point, the first one's the lowest: its square in floats, (x² + y²) + z², is not above the
  /// limit, nor certainly above the least of all.
  std::uint64_t (*near)(const OctreeNearTask& task) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const OctreeKernels plain_octree_kernels;
#if defined(__x86_64__)
extern const OctreeKernels avx2_octree_kernels;    ///< needs AVX2 and POPCNT
extern const OctreeKernels avx512_octree_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
