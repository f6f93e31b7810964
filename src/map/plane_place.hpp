// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/plane_row.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Neither a value beyond the bounds nor NaN comes through: that becomes the bound.
inline double bounded(double x, double bound) noexcept {
  const double below = x < bound ? x : bound;
  return below > -bound ? below : -bound;
}

/// Steps 1 and 2, sixteen pixels from n on. Plain arithmetic, which compilers turn into vector instructions.
inline void place_all(const PlaneRowPart& part, const PlaneOfRow& plane, const std::uint16_t* raw,
                      std::int32_t n, PlaneRowPlaces& places) noexcept {
  std::int32_t* const i = places.i + places.guard + n;
  std::int32_t* const j = places.j + places.guard + n;
  std::int32_t* const k = places.k + places.guard + n;
  std::int32_t* const residual = places.residual + places.guard + n;
  const double end = plane_row::grid_end;
  const std::int32_t first = part.first + n;
  const double per_unit = part.metres_per_unit, by_u = plane.by_u, constant = plane.constant;
  const double distance = plane.distance;
  const double ax = part.along_u[0], ay = part.along_u[1], az = part.along_u[2];
  const double rx = part.row[0], ry = part.row[1], rz = part.row[2];
  const double ox = part.origin[0], oy = part.origin[1], oz = part.origin[2];
  for (std::int32_t lane = 0; lane < 16; ++lane) {
    const double u = first + lane;
    const double inverse = by_u * u + constant;
    const double z = 1 / inverse;
    i[lane] = static_cast<std::int32_t>(bounded(z * (u * ax + rx) + ox, end));
    j[lane] = static_cast<std::int32_t>(bounded(z * (u * ay + ry) + oy, end));
    k[lane] = static_cast<std::int32_t>(bounded(z * (u * az + rz) + oz, end));
    const double beyond = raw[lane] * per_unit * inverse - 1;
    residual[lane] = static_cast<std::int32_t>(bounded(beyond * distance, plane_row::most_residual));
  }
}

/// Makes i negative where there is no place, or none near the plane.
inline void mark(const PlaneOfRow& plane, std::int32_t n, PlaneRowPlaces& places) noexcept {
  std::int32_t* const i = places.i + places.guard + n;
  const std::int32_t* const j = places.j + places.guard + n;
  const std::int32_t* const k = places.k + places.guard + n;
  const std::int32_t* const residual = places.residual + places.guard + n;
  const std::int32_t far_off = plane.far_off;
  for (std::int32_t lane = 0; lane < 16; ++lane) {
    const std::int32_t r = residual[lane];
    const auto highest = static_cast<std::uint32_t>(i[lane] | j[lane] | k[lane]);
    const bool beyond = (r > far_off) | (r < -far_off) | (highest >= plane_row::grid_end);
    i[lane] |= beyond ? INT32_MIN : 0;
  }
}

inline std::uint32_t leaf_changes(const PlaneRowPlaces& p, std::int32_t n) noexcept {
  std::uint32_t changes = 0;
  for (std::int32_t bit = 0; bit < 16; ++bit) {
    const std::int32_t at = p.guard + n + bit;
    const auto change = static_cast<std::uint32_t>((p.i[at] ^ p.i[at - 1]) | (p.j[at] ^ p.j[at - 1]) |
                                                   (p.k[at] ^ p.k[at - 1]));
    changes |= (change >= plane_row::leaf_side ? 1U : 0U) << static_cast<unsigned>(bit);
  }
  return changes;
}

/// Places sixteen pixels from n on. Bit b of the result is set where pixel n + b lies in another leaf than
/// the one before it.
inline std::uint32_t place(const PlaneRowPart& part, const PlaneOfRow& plane, const std::uint16_t* raw,
                           std::int32_t n, PlaneRowPlaces& places) noexcept {
  place_all(part, plane, raw, n, places);
  mark(plane, n, places);
  return leaf_changes(places, n);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
