// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/detail/plane_run.hpp"

/// What the kernels of registering work on. They include this: no functions here.
namespace straightedge {

/// A frame's plane by its pixels: 1/z = by_u · u + normal · ray / distance.
struct PixelPlane {
  double normal[3] = {};
  double by_u = 0, by_distance = 0;
  double distance = 0;       ///< quanta
  std::int32_t far_off = 0;  ///< residuals beyond ± this are no readings of the plane, quanta
};

/// The plane in one row: 1/z = by_u · u + constant.
struct PlaneOfRow {
  double by_u, constant, distance;
  std::int32_t far_off;
};

/// Neighbouring pixels of one row, and all that places them.
struct PlaneRowPart {
  static constexpr std::int32_t most = 1024;  ///< pixels

  const std::uint16_t* raw = nullptr;
  const std::uint16_t* labels = nullptr;
  const PixelPlane* planes = nullptr;  ///< that of label 1 first
  std::int32_t first = 0;              ///< column
  std::int32_t count = 0;              ///< pixels, at least 1
  std::int32_t to_row_end = 0;         ///< pixels of the row from the first one on
  double metres_per_unit = 0;
  double ray[3] = {};                                   ///< through the row's pixel at u = 0
  double along_u[3] = {}, row[3] = {}, origin[3] = {};  ///< place = z (u along_u + row) + origin, quanta
};

/// The places of a part's pixels, quanta; of those that have none i is negative. What comes after the part's
/// end, up to the next multiple of 16, may be anything.
struct PlaneRowPlaces {
  static constexpr std::int32_t guard = 16;  ///< before and after
  static constexpr std::int32_t all = guard + PlaneRowPart::most + guard;

  std::int32_t i[all] = {}, j[all] = {}, k[all] = {}, residual[all] = {};
  std::uint64_t changes[PlaneRowPart::most / 64 + 2] =
      {};                         ///< a bit for each pixel where a label or leaf begins
  std::uint16_t raw[guard] = {};  ///< the last pixels of a row
};

/// Readings that found no place.
struct LeftOut {
  std::uint64_t off_plane = 0;
  std::uint64_t out_of_range = 0;
};

/// One such table for each set of kernels.
struct PlaneRowKernels {
  std::uint16_t (*largest_label)(const std::uint16_t* labels, std::int32_t count) noexcept;
  /// Registers a part of a row. The table of runs must have room for as many runs as the part has pixels.
  void (*add)(const PlaneRowPart& part, PlaneRowPlaces& places, detail::PlaneRunTable& runs,
              LeftOut& out) noexcept;
};

namespace plane_row {
inline constexpr std::int32_t grid_bits = 29, grid_end = 1 << grid_bits;  ///< places are below, quanta
inline constexpr std::int32_t most_residual = 1 << 20;
inline constexpr std::int32_t leaf_bits = 8, leaf_side = 1 << leaf_bits;
}  // namespace plane_row

}  // namespace straightedge
