// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of DepthCells and FramePlanes: one table of functions. The plain table is always there;
/// others are made from the same text for more instructions, and give the same bits. Which of them this
/// machine can run, the application must know (host/kernels.hpp asks the processor): a table's functions
/// stop a program that has not the instructions.
namespace straightedge {

/// Rows of 1/z; strides count elements.
struct DepthRows {
  const float* first = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Sums over a square of pixels, u and v counted from its corner. What is not above 0 counts as 0.
struct DepthCellSums {
  double q = 0, uq = 0, vq = 0, qq = 0;
  std::int32_t n = 0;  ///< pixels above 0
};

/// A rectangle of pixels whose only plane is at + along x + down y, x and y from its corner.
struct DepthBlock {
  DepthRows rows;
  std::int32_t width = 0, height = 0;  ///< at most `most_height` rows
  double at = 0, along = 0, down = 0;  ///< 1/metre
  float limit = 0;                     ///< the gate, 1/metre
  std::uint16_t label = 0;

  static constexpr std::int32_t most_height = 32;
};

struct DepthBlockCounts {
  std::int32_t labelled = 0;
  std::uint32_t rows_missed = 0;  ///< bit y: readings of row y lie outside of the gate
};

/// Planes to choose from for 4x4 pixels: plane k is at[k] + along[k] x + down[k] y, x and y from their
/// corner.
struct DepthChoice {
  static constexpr std::int32_t side = 4, stride = 8, most_planes = 9;
  /// The pixels with one more on every side, row by row; 0 is no reading.
  float around[(side + 2) * stride];
  float at[most_planes], along[most_planes], down[most_planes];
  std::int32_t planes;
  /// Deviation of 1/z where it is q: the larger of noise and noise_of_square q²; the gate is `sigmas` of it.
  float noise, noise_of_square, sigmas;
};

/// Quadratic surfaces c + x X + y Y + xx X² + xy X Y + yy Y², an array for each coefficient.
struct DepthSurfaces {
  static constexpr std::int32_t step = 16;  ///< arrays are as long as a multiple of it
  float *c = nullptr, *x = nullptr, *y = nullptr, *xx = nullptr, *xy = nullptr, *yy = nullptr;
  std::int32_t count = 0;  ///< a multiple of `step`
};

struct DepthKernels {
  /// scale / raw, rounded once; 0 where raw is 0.
  void (*invert)(const std::uint16_t* raw, std::int32_t width, float scale, float* inverse) noexcept;

  /// The squares of side 4, 8 or 16 that lie in a row from the corner on.
  void (*sum_cells)(const DepthRows& corner, std::int32_t side, std::int32_t cells,
                    DepthCellSums* sums) noexcept;

  /// Readings within the gate get the label, all others 0.
  DepthBlockCounts (*label_block)(const DepthBlock& block, std::uint16_t* labels,
                                  std::ptrdiff_t stride) noexcept;

  /// For each of the 4x4 pixels 1 + the nearest plane within the gate, or 0. Where two planes are nearly as
  /// near (4 deviations), the mean of the 3x3 pixels of the pixel's own surface (8 deviations) decides.
  void (*choose)(const DepthChoice& pixels, std::int32_t* chosen) noexcept;

  /// Bit k % 16 of near[k / 16] tells whether (q − surface k at (x, y))² <= limit.
  void (*near)(const DepthSurfaces& surfaces, float x, float y, float q, float limit,
               std::uint32_t* near) noexcept;
};

/// What the firmware runs and what every other table is compared with.
extern const DepthKernels plain_depth_kernels;

#if defined(__x86_64__)
extern const DepthKernels avx2_depth_kernels;    ///< needs AVX2 and POPCNT
extern const DepthKernels avx512_depth_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
