// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/detail/plane_run.hpp"

/// What the kernels of registering work on. They include this: no functions here.
namespace straightedge {

/// A frame's plane by its pixels: 1/z = by_u · u + by_v · v + constant.
struct PixelPlane {
  double by_u = 0, by_v = 0, constant = 0;
  double distance = 0;       ///< quanta
  std::int32_t far_off = 0;  ///< residuals beyond ± this are no readings of the plane, quanta
};

/// Where a pixel's place lies on the grid: z (u · along_u + v · along_v + corner) + origin, quanta.
struct GridCamera {
  double along_u[3] = {}, along_v[3] = {}, corner[3] = {}, origin[3] = {};
};

/// Four rows of pixels, cut into squares of 4x4, and all that places them.
struct PlaneRow {
  static constexpr std::int32_t side = 4;
  static constexpr std::int32_t at_once = 16;        ///< columns
  static constexpr std::int32_t most_columns = 640;  ///< a multiple of the former
  static constexpr std::int32_t most_squares = most_columns / side;
  static constexpr std::int32_t most_runs = side * most_columns;  ///< that one row can begin

  const std::uint16_t* raw[side] = {};
  const std::uint16_t* labels[side] = {};  ///< 0 where the picture has no pixels
  /// The rows after these, which a processor would not ask memory for in time; where there are none, these.
  const std::uint16_t* next[2 * side] = {};
  std::int32_t columns = 0;   ///< a multiple of 16
  std::int32_t u = 0, v = 0;  ///< first column, first row
  double metres_per_unit = 0;
  GridCamera grid;
  const PixelPlane* planes = nullptr;  ///< that of label 1 first
  std::uint32_t plane_count = 0;
};

/// What the readings of a plane in each column of four pixels come to. Memory of the kernels: all zeros
/// before its first use.
struct PlaneColumns {
  static constexpr std::int32_t size = PlaneRow::most_columns + 32;

  static constexpr std::int32_t place_bits = 8, place = 1 << place_bits;

  std::int32_t readings[size] = {};  ///< how many, and `place` times the sum of their places, 0 to 3
  float residual[size] = {};         ///< squares, quanta²
};

/// What became of the readings of rows.
struct PlaneRowCounts {
  std::uint64_t labelled = 0;
  std::uint64_t near_plane = 0;    ///< of these
  std::uint64_t out_of_range = 0;  ///< of the latter
  std::uint32_t largest_label = 0;
};

/// One such table for each set of kernels.
struct PlaneRowKernels {
  /// Registers a row of squares; one with a label that has no plane is passed over. The table must have room
  /// for `most_runs` more.
  void (*add)(const PlaneRow& row, PlaneColumns& columns, detail::PlaneRunTable& runs,
              PlaneRowCounts& counts) noexcept;
};

namespace plane_row {
inline constexpr std::int32_t grid_bits = 29, grid_end = 1 << grid_bits;  ///< places are below, quanta
inline constexpr std::int32_t most_residual = 1 << 20;
inline constexpr std::int32_t leaf_bits = 8, leaf_side = 1 << leaf_bits;
}  // namespace plane_row

}  // namespace straightedge
