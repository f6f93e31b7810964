// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/lattice.hpp"

#include "ransac/reading.hpp"
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
    m.q[i] = m.free_q[i] = no_reading;
    m.w[i] = 1;
  }
  for (std::size_t i = 0; i < m.hit.size(); ++i) m.hit[i] = m.core[i] = 0;
}

/// A part of the picture.
struct Pixels {
  std::int32_t u0 = 0, v0 = 0, width = 0, height = 0;
};

/// False: no reading, or masked. The mask is asked first: it is cheaper.
bool read_free(ImageView<const float> inverse_depth, ImageView<const std::uint16_t> mask, std::int32_t u,
               std::int32_t v, const PlaneGate& gate, float& q, float& w) noexcept {
  if (mask.data != nullptr && mask.at(u, v) != 0) return false;
  q = inverse_depth.at(u, v);
  if (!(q > 0)) return false;
  w = inverse_gate(gate, q);
  return is_reading(q, w);
}

/// Begins at a pixel drawn by chance and takes the first reading from there on, row by row and round again.
bool draw_reading(const Lattice& lattice, const Pixels& p, std::size_t cell,
                  ImageView<const float> inverse_depth, ImageView<const std::uint16_t> mask,
                  const PlaneGate& gate, Pcg32& random) noexcept {
  std::int32_t u = p.u0 + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(p.width)));
  std::int32_t v = p.v0 + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(p.height)));
  for (std::int32_t tried = 0; tried < p.width * p.height; ++tried) {
    float q = 0, w = 0;
    if (read_free(inverse_depth, mask, u, v, gate, q, w)) {
      lattice.memory.u[cell] = static_cast<float>(u);
      lattice.memory.v[cell] = static_cast<float>(v);
      lattice.memory.q[cell] = lattice.memory.free_q[cell] = q;
      lattice.memory.w[cell] = w;
      return true;
    }
    if (++u == p.u0 + p.width) {
      u = p.u0;
      if (++v == p.v0 + p.height) v = p.v0;
    }
  }
  return false;
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
    for (std::int32_t column = 0; column < lattice.columns; ++column) {
      const std::int32_t u0 = column * lattice.cell;
      const std::int32_t width = clamped(inverse_depth.width - u0, lattice.cell);
      if (draw_reading(lattice, {u0, v0, width, height}, lattice.at(column, row), inverse_depth, mask,
                       options.gate, random))
        ++readings;
    }
  }
  return readings;
}

}  // namespace straightedge::ransac
