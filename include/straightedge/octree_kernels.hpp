// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loop of Octree::build (octree.hpp) over the coordinates, as a table. The plain table is always
/// there; others hold the same text compiled for more instructions, which gives the same bits. Which of them
/// this machine can run, the application must know (host/kernels.hpp asks the processor): a table's functions
/// stop a program that has not the instructions.
namespace straightedge {

/// One axis of an octree's cells: cell = floor((x - origin) * scale + offset), from 0 to below `end`.
struct OctreeAxis {
  double origin = 0, scale = 1, offset = 0, end = 0;
};

struct OctreeKernels {
  /// Cells of coordinates; -1 for one that is outside or not a number.
  void (*cells)(const float* coordinates, std::size_t count, const OctreeAxis& axis,
                std::int32_t* cells) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const OctreeKernels plain_octree_kernels;
#if defined(__x86_64__)
extern const OctreeKernels avx2_octree_kernels;    ///< needs AVX2 and POPCNT
extern const OctreeKernels avx512_octree_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
