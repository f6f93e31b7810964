// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "map/plane_row.hpp"
#if defined(__AVX512BW__)
#include "map/fast/doubles_avx512.hpp"
#else
#include "map/fast/doubles_avx2.hpp"
#endif

// The same results as plane_place.hpp; read that first.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// The pixels from n on, as many as Wholes has lanes.
inline std::uint32_t place_some(const PlaneRowPart& part, const PlaneOfRow& plane, const std::uint16_t* raw,
                                std::int32_t n, PlaneRowPlaces& places) noexcept {
  const auto all = [](double value) { return Doubles::all(value); };
  const Doubles u[2] = {Doubles::counted_from(part.first + n),
                        Doubles::counted_from(part.first + n + Doubles::count)};
  const Doubles inverse[2] = {all(plane.by_u) * u[0] + all(plane.constant),
                              all(plane.by_u) * u[1] + all(plane.constant)};
  const Doubles z[2] = {all(1) / inverse[0], all(1) / inverse[1]};
  const auto along = [&](int axis) {
    const Doubles by_u = all(part.along_u[axis]), row = all(part.row[axis]), origin = all(part.origin[axis]);
    return Wholes::of(z[0] * (u[0] * by_u + row) + origin, z[1] * (u[1] * by_u + row) + origin,
                      plane_row::grid_end);
  };
  const auto off_plane = [&](int half) {
    const Doubles units = Doubles::load(raw + half * Doubles::count);
    return (units * all(part.metres_per_unit) * inverse[half] - all(1)) * all(plane.distance);
  };
  const Wholes residual = Wholes::of(off_plane(0), off_plane(1), plane_row::most_residual);
  const Wholes j = along(1), k = along(2);
  Wholes i = along(0);
  const auto beyond =
      Wholes::either(residual.magnitude().above(plane.far_off), (i | j | k).above_bits(plane_row::grid_bits));
  i = i.or_where(beyond, INT32_MIN);

  const std::int32_t at = places.guard + n;
  const auto change = [at](const Wholes& now, const std::int32_t* stored) {
    return now ^ now.shifted(stored[at - 1]);
  };
  const Wholes changes = change(i, places.i) | change(j, places.j) | change(k, places.k);
  i.store(places.i + at);
  j.store(places.j + at);
  k.store(places.k + at);
  residual.store(places.residual + at);
  return Wholes::bits(changes.above_bits(plane_row::leaf_bits));
}

inline std::uint32_t place(const PlaneRowPart& part, const PlaneOfRow& plane, const std::uint16_t* raw,
                           std::int32_t n, PlaneRowPlaces& places) noexcept {
  std::uint32_t changes = 0;
  for (std::int32_t lane = 0; lane < 16; lane += Wholes::count)
    changes |= place_some(part, plane, raw + lane, n + lane, places) << static_cast<unsigned>(lane);
  return changes;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
