// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of RansacPlanes (ransac_planes.hpp): one table of functions. The plain table is always
/// there; others hold faster twins, which give the same bits. Which of them this machine can run, the
/// application must know (host/kernels.hpp asks the processor): a table's functions stop a program that has
/// not the instructions.
///
/// Sums of floats are 16 interleaved partial sums, element i in sum i mod 16, each in order; then the halves
/// are added onto one another, 8 apart, 4, 2, 1. Other sums are of whole numbers.
namespace straightedge {

inline constexpr std::uint32_t ransac_lanes = 16;

/// The subset as rows of four numbers, structure of arrays. Row times coefficients is the residual e of a
/// plane in units of the gate. `count` is a multiple of 16; rows of zeros, which cost no plane anything, fill
/// the last lanes up.
struct RansacRows {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* w = nullptr;
  std::uint32_t count = 0;
};

struct RansacCoefficients {
  float x = 0, y = 0, z = 0, w = 0;
};

/// Coefficients of as many planes.
struct RansacBatch {
  float x[ransac_lanes], y[ransac_lanes], z[ransac_lanes], w[ransac_lanes];
};

/// Sums over rows, of products of two coordinates s, t, of w, and of e.
struct RansacChangeSums {
  float ss = 0, st = 0, sw = 0, tt = 0, tw = 0, ww = 0, se = 0, te = 0, we = 0;
};

/// Neighbouring pixels of a row of a frame: Q is float, 1/z, or std::uint16_t, depth with `scale` / depth as
/// 1/z. One takes part if it is a reading without a label: 1/z = q above its gate and at most 1e6. The gate
/// is max(constant, metres q²). Inliers have |q − (a i + c)| below it.
template <class Q>
struct RansacPixels {
  const Q* pixels = nullptr;
  const std::uint16_t* labels = nullptr;  ///< null: none has one
  std::int32_t count = 0;                 ///< at most ransac_most_pixels
  float scale = 1;
  float a = 0, c = 0;
  float constant = 0, metres = 0;
};

inline constexpr std::int32_t ransac_most_pixels = 768;

/// How many take part, and sums over the inliers: number, column i, its square, residual r from the plane.
struct RansacPixelSums {
  std::uint32_t readings = 0, n = 0, u = 0, uu = 0;
  float r = 0, ur = 0, rr = 0;
};

/// Some points, `step` floats from one to the next, counted from an origin. One takes part if it is finite
/// and has no label. Inliers have |r| below the gate, r = plane · (x, y, z, 1).
struct RansacPoints {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const std::uint16_t* labels = nullptr;  ///< null: none has one
  std::int32_t count = 0;
  std::ptrdiff_t step = 1;
  float origin_x = 0, origin_y = 0, origin_z = 0;
  RansacCoefficients plane;
  float gate = 0;
};

/// How many take part, and sums over the inliers.
struct RansacPointSums {
  std::uint32_t readings = 0, n = 0;
  float x = 0, y = 0, xx = 0, xy = 0, yy = 0, r = 0, xr = 0, yr = 0, rr = 0;
};

struct RansacKernels {
  /// costs[h]: sum over the rows, in order, of min(e², 1) for plane h.
  void (*batch_costs)(const RansacRows& rows, const RansacBatch& planes, float* costs) noexcept;
  /// The sum of min(e², 1).
  float (*row_cost)(const RansacRows& rows, const RansacCoefficients& plane) noexcept;
  /// How many rows have e² < 1.
  std::uint32_t (*count_rows)(const RansacRows& rows, const RansacCoefficients& plane) noexcept;
  /// Sums over the rows with e² < limit. s and t: two of the rows' columns.
  RansacChangeSums (*sum_changes)(const RansacRows& rows, const RansacCoefficients& plane, const float* s,
                                  const float* t, float limit) noexcept;

  template <class Q>
  struct Pixels {
    RansacPixelSums (*sum)(const RansacPixels<Q>& row) noexcept;
    /// Inliers.
    std::uint32_t (*count)(const RansacPixels<Q>& row) noexcept;
  };
  Pixels<float> inverse;
  Pixels<std::uint16_t> raw;

  RansacPointSums (*sum_points)(const RansacPoints& points) noexcept;
  /// Inliers.
  std::uint32_t (*count_points)(const RansacPoints& points) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const RansacKernels plain_ransac_kernels;

#if defined(__x86_64__)
extern const RansacKernels avx2_ransac_kernels;    ///< needs AVX2 and POPCNT
extern const RansacKernels avx512_ransac_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
