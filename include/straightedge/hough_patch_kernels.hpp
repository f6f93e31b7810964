// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loop of HoughPatchSearch (hough_plane_patches.hpp) over the pixels, as a table. The plain table
/// is always there; others hold the same text compiled for more instructions, which gives the same bits.
/// Which of them this machine can run, the application must know (host/kernels.hpp asks the processor): a
/// table's functions stop a program that has not the instructions.
namespace straightedge {

/// Sums over the readings of a square of 8 x 8 pixels. u and v count from its corner, q from the reference.
/// Each is the sum of the sums of its eight columns: added up four apart, two, one.
struct SquareSums {
  float reference = 0;  ///< a reading of the square; 0 if it has none
  float q = 0, uq = 0, vq = 0, qq = 0;
  std::uint8_t seen[8] = {};  ///< a number for each column: bit v tells that pixel v is a reading
  bool whole = false;         ///< all pixels are
};

struct HoughPatchKernels {
  /// Two squares beside one another, rows `stride` floats apart. A reading is above 0 and at most `farthest`.
  void (*sum_squares)(const float* pixels, std::ptrdiff_t stride, float farthest,
                      SquareSums (&sums)[2]) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const HoughPatchKernels plain_hough_patch_kernels;
#if defined(__x86_64__)
extern const HoughPatchKernels avx2_hough_patch_kernels;    ///< needs AVX2 and POPCNT
extern const HoughPatchKernels avx512_hough_patch_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
