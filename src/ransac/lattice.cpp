// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/lattice.hpp"

#include <cstring>

#include "straightedge/random.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::int32_t clamped(std::int32_t x, std::int32_t most) noexcept {
  return x < 0 ? 0 : (x > most ? most : x);
}

void clear(const Lattice& lattice) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  for (std::size_t i = 0; i < m.q.size(); ++i) {
    m.u[i] = m.v[i] = 0;
    m.q[i] = no_reading;
    m.w[i] = 1;
  }
  for (std::size_t i = 0; i < m.hit.size(); ++i) m.hit[i] = m.core[i] = 0;
}

/// A part of the picture, and its readings.
struct Square {
  ImageView<const float> inverse_depth;
  ImageView<const std::uint16_t> mask;
  std::int32_t u0 = 0, v0 = 0, width = 0, height = 0;

  bool masked(std::int32_t u, std::int32_t v) const noexcept {
    return mask.data != nullptr && mask.at(u0 + u, v0 + v) != 0;
  }
  /// 0: none that takes part.
  float reading(std::int32_t u, std::int32_t v) const noexcept {
    // The mask is asked first: it is smaller.
    if (masked(u, v)) return 0;
    const float q = inverse_depth.at(u0 + u, v0 + v);
    return q > 0 && q <= 1e6F ? q : 0;
  }
};

/// Masks leave out most of a picture.
bool all_masked(const Square& s) noexcept {
  if (s.mask.data == nullptr) return false;
  std::uint32_t free = 0;
  for (std::int32_t v = 0; v < s.height; ++v) {
    const std::uint16_t* row = s.mask.row(s.v0 + v) + s.u0;
    std::uint16_t any = 0;
    for (std::int32_t u = 0; u < s.width; ++u) any = static_cast<std::uint16_t>(any | (row[u] == 0 ? 1 : 0));
    free |= any;
  }
  return free == 0;
}

/// The first reading behind pixel (u, v), row by row and round again; u and v become its place. 0: none.
float next_reading(const Square& s, std::int32_t& u, std::int32_t& v) noexcept {
  for (std::int32_t tried = 1; tried < s.width * s.height; ++tried) {
    if (++u == s.width) {
      u = 0;
      v = v + 1 == s.height ? 0 : v + 1;
    }
    const float q = s.reading(u, v);
    if (q > 0) return q;
  }
  return 0;
}

/// The readings of some cells beside one another, of each the first from pixel (du, dv) of its square on.
void take_readings(const Lattice& lattice, Square s, std::int32_t column, std::int32_t end, std::int32_t row,
                   std::int32_t du, std::int32_t dv) noexcept {
  s.u0 = column * lattice.cell;
  s.width = clamped(s.inverse_depth.width - s.u0, (end - column) * lattice.cell);
  if (all_masked(s)) return;
  for (; column < end; ++column) {
    s.u0 = column * lattice.cell;
    s.width = clamped(s.inverse_depth.width - s.u0, lattice.cell);
    std::int32_t u = du < s.width ? du : s.width - 1, v = dv;
    float q = s.reading(u, v);
    if (!(q > 0) && !all_masked(s)) q = next_reading(s, u, v);
    if (!(q > 0)) continue;
    const std::size_t cell = lattice.at(column, row);
    lattice.memory.u[cell] = static_cast<float>(s.u0 + u);
    lattice.memory.v[cell] = static_cast<float>(s.v0 + v);
    lattice.memory.q[cell] = q;
  }
}

/// The gates of the readings of a row, and the readings that no candidate has taken: all of them.
std::uint32_t weigh_row(const Lattice& lattice, std::size_t first, const PlaneGate& gate) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  const double square = gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m;
  const double least = gate.fixed_m > 0 ? 0 : gate.sigmas * gate.inverse_sigma;
  const std::int32_t count = (lattice.columns + cell_lanes - 1) / cell_lanes * cell_lanes;
  lattice.kernels.weigh(&m.q[first], &m.w[first], count, static_cast<float>(least), static_cast<float>(square),
                        no_reading);
  std::uint32_t readings = 0;
  for (std::size_t i = first; i < first + static_cast<std::size_t>(lattice.columns); ++i)
    readings += m.q[i] > 0 ? 1U : 0U;
  return readings;
}

}  // namespace

CellBox box_round(const Lattice& lattice, std::int32_t column, std::int32_t row, std::int32_t half) noexcept {
  const std::int32_t x0 = clamped(column - half, lattice.columns) / cell_lanes * cell_lanes;
  const std::int32_t x1 =
      (clamped(column + half + 1, lattice.columns) + cell_lanes - 1) / cell_lanes * cell_lanes;
  return {x0, clamped(row - half, lattice.rows), clamped(x1, lattice.columns),
          clamped(row + half + 1, lattice.rows)};
}

CellBox widened(const Lattice& lattice, const CellBox& box, std::int32_t cells) noexcept {
  const std::int32_t x1 = (box.x1 + cells + cell_lanes - 1) / cell_lanes * cell_lanes;
  return {clamped(box.x0 - cells, lattice.columns) / cell_lanes * cell_lanes,
          clamped(box.y0 - cells, lattice.rows), clamped(x1, lattice.columns),
          clamped(box.y1 + cells, lattice.rows)};
}

std::uint32_t draw_lattice(const Lattice& lattice, ImageView<const float> inverse_depth,
                           ImageView<const std::uint16_t> mask, const RansacSearchOptions& options) noexcept {
  clear(lattice);
  std::uint32_t readings = 0;
  for (std::int32_t row = 0; row < lattice.rows; ++row) {
    Pcg32 random(options.seed, static_cast<std::uint64_t>(row));
    const std::int32_t v0 = row * lattice.cell;
    const std::int32_t height = clamped(inverse_depth.height - v0, lattice.cell);
    for (std::int32_t column = 0; column < lattice.columns; column += cell_lanes) {
      // One draw for sixteen cells: so memory is read in rows.
      const auto du = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(lattice.cell)));
      const auto dv = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(height)));
      const std::int32_t end = clamped(column + cell_lanes, lattice.columns);
      take_readings(lattice, {inverse_depth, mask, 0, v0, 0, height}, column, end, row, du, dv);
    }
    readings += weigh_row(lattice, lattice.at(0, row), options.gate);
  }
  std::memcpy(lattice.memory.free_q.data(), lattice.memory.q.data(), lattice.memory.q.size_bytes());
  return readings;
}

}  // namespace straightedge::ransac
