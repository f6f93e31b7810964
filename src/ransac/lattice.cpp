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

/// The picture's pixels that may be drawn.
struct Picture {
  ImageView<const float> inverse_depth;
  ImageView<const std::uint16_t> mask;

  bool masked() const noexcept { return mask.data != nullptr; }
};

/// A part of it.
struct Pixels {
  std::int32_t u0 = 0, v0 = 0, width = 0, height = 0;
};

constexpr bool is_depth(float q) noexcept {
  return q > 0 && q <= 1e6F;
}

/// Masks leave out most of a picture.
bool all_masked(const Picture& picture, const Pixels& p) noexcept {
  std::uint32_t free = 0;
  for (std::int32_t v = 0; v < p.height; ++v) {
    const std::uint16_t* row = picture.mask.row(p.v0 + v) + p.u0;
    std::uint16_t any = 0;
    for (std::int32_t u = 0; u < p.width; ++u) any = static_cast<std::uint16_t>(any | (row[u] == 0 ? 1 : 0));
    free |= any;
  }
  return free == 0;
}

/// Each cell's reading in one row of pixels.
void take_row(const Lattice& lattice, const Picture& picture, std::int32_t column, std::int32_t end,
              std::int32_t row, std::int32_t du, std::int32_t v) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  const float* depths = picture.inverse_depth.row(v);
  const std::int32_t last = picture.inverse_depth.width - 1;
  // The last cell may be cut off.
  const std::int32_t whole = (end - 1) * lattice.cell + du <= last ? end : end - 1;
  const std::size_t first = lattice.at(column, row);
  float *u = &m.u[first], *v_of = &m.v[first], *q = &m.q[first];
  lattice.kernels.take_readings(depths + column * lattice.cell + du, lattice.cell, whole - column, no_reading,
                                q);
  for (std::int32_t i = 0; i < end - column; ++i) {
    u[i] = static_cast<float>((column + i) * lattice.cell + du);
    v_of[i] = static_cast<float>(v);
  }
  if (whole < end) {
    u[whole - column] = static_cast<float>(last);
    q[whole - column] = is_depth(depths[last]) ? depths[last] : no_reading;
  }
  if (!picture.masked()) return;
  const std::uint16_t* masks = picture.mask.row(v);
  for (std::int32_t i = 0; i < end - column; ++i) {
    const std::int32_t x = (column + i) * lattice.cell + du;
    if (masks[x < last ? x : last] != 0) q[i] = no_reading;
  }
}

/// The first reading of a cell's square, row by row from dv on and round again.
void take_next(const Lattice& lattice, const Picture& picture, const Pixels& p, std::int32_t dv,
               std::size_t cell) noexcept {
  if (picture.masked() && all_masked(picture, p)) return;
  for (std::int32_t tried = 0; tried < p.height; ++tried) {
    const std::int32_t v = p.v0 + (dv + tried < p.height ? dv + tried : dv + tried - p.height);
    const float* depths = picture.inverse_depth.row(v);
    for (std::int32_t u = p.u0; u < p.u0 + p.width; ++u) {
      if (!is_depth(depths[u]) || (picture.masked() && picture.mask.at(u, v) != 0)) continue;
      lattice.memory.u[cell] = static_cast<float>(u);
      lattice.memory.v[cell] = static_cast<float>(v);
      lattice.memory.q[cell] = depths[u];
      return;
    }
  }
}

/// The readings of some cells beside one another, from pixel (du, dv) of each square on.
void take_readings(const Lattice& lattice, const Picture& picture, std::int32_t column, std::int32_t row,
                   std::int32_t du, std::int32_t dv) noexcept {
  const std::int32_t end = clamped(column + cell_lanes, lattice.columns);
  Pixels p{column * lattice.cell, row * lattice.cell, 0, 0};
  p.height = clamped(picture.inverse_depth.height - p.v0, lattice.cell);
  p.width = clamped(picture.inverse_depth.width - p.u0, (end - column) * lattice.cell);
  if (picture.masked() && all_masked(picture, p)) {
    for (std::int32_t c = column; c < end; ++c) lattice.memory.q[lattice.at(c, row)] = no_reading;
    return;
  }
  take_row(lattice, picture, column, end, row, du, p.v0 + dv);
  for (; column < end; ++column) {
    const std::size_t cell = lattice.at(column, row);
    if (lattice.memory.q[cell] > 0) continue;
    p.u0 = column * lattice.cell;
    p.width = clamped(picture.inverse_depth.width - p.u0, lattice.cell);
    take_next(lattice, picture, p, dv, cell);
  }
}

/// The gates of the readings of a row, and the readings that no candidate has taken: all of them.
std::uint32_t weigh_row(const Lattice& lattice, std::size_t first, const PlaneGate& gate) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  const double square = gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m;
  const double least = gate.fixed_m > 0 ? 0 : gate.sigmas * gate.inverse_sigma;
  const std::int32_t count = (lattice.columns + cell_lanes - 1) / cell_lanes * cell_lanes;
  lattice.kernels.weigh(&m.q[first], &m.w[first], count, static_cast<float>(least),
                        static_cast<float>(square), no_reading);
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

void clear_lattice(const Lattice& lattice) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  for (std::size_t i = 0; i < m.q.size(); ++i) {
    m.u[i] = m.v[i] = 0;
    m.q[i] = no_reading;
    m.w[i] = 1;
  }
  for (std::size_t i = 0; i < m.hit.size(); ++i) m.hit[i] = m.core[i] = 0;
}

std::uint32_t draw_lattice(const Lattice& lattice, ImageView<const float> inverse_depth,
                           ImageView<const std::uint16_t> mask, const RansacSearchOptions& options) noexcept {
  std::uint32_t readings = 0;
  for (std::int32_t row = 0; row < lattice.rows; ++row) {
    Pcg32 random(options.seed, static_cast<std::uint64_t>(row));
    const std::int32_t height = clamped(inverse_depth.height - row * lattice.cell, lattice.cell);
    for (std::int32_t column = 0; column < lattice.columns; column += cell_lanes) {
      // One draw for sixteen cells: so memory is read in rows.
      const auto du = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(lattice.cell)));
      const auto dv = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(height)));
      take_readings(lattice, {inverse_depth, mask}, column, row, du, dv);
    }
    readings += weigh_row(lattice, lattice.at(0, row), options.gate);
  }
  std::memcpy(lattice.memory.free_q.data(), lattice.memory.q.data(), lattice.memory.q.size_bytes());
  return readings;
}

void widen_gates(const Lattice& lattice, double times) noexcept {
  if (times == 1) return;
  for (std::int32_t row = 0; row < lattice.rows; ++row) {
    float* w = &lattice.memory.w[lattice.at(0, row)];
    for (std::int32_t column = 0; column < lattice.columns; ++column) w[column] /= static_cast<float>(times);
  }
}

}  // namespace straightedge::ransac
