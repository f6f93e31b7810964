// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/lattice.hpp"

namespace straightedge::ransac {
namespace {

/// Residual of a cell's pixels from its own plane, gates of pixels: noise leaves a third.
constexpr float own_residual = 0.5F;

constexpr std::int32_t clamped(std::int32_t x, std::int32_t most) noexcept {
  return x < 0 ? 0 : (x > most ? most : x);
}

/// [x0, x1) in whole groups.
constexpr std::int32_t group_before(std::int32_t x0) noexcept {
  return x0 / cell_lanes * cell_lanes;
}
constexpr std::int32_t group_after(std::int32_t x1) noexcept {
  return (x1 + cell_lanes - 1) / cell_lanes * cell_lanes;
}

CellBox clipped(const Lattice& l, std::int32_t x0, std::int32_t y0, std::int32_t x1,
                std::int32_t y1) noexcept {
  return {group_before(clamped(x0, l.columns)), clamped(y0, l.rows),
          clamped(group_after(clamped(x1, l.columns)), l.columns), clamped(y1, l.rows)};
}

}  // namespace

CellBox box_round(const Lattice& lattice, std::int32_t column, std::int32_t row, std::int32_t half) noexcept {
  return clipped(lattice, column - half, row - half, column + half + 1, row + half + 1);
}

CellBox box_over(const Lattice& lattice, const Lattice& of, const CellBox& box) noexcept {
  return clipped(lattice, box.x0 * of.cell / lattice.cell - 1, box.y0 * of.cell / lattice.cell - 1,
                 (box.x1 * of.cell - 1) / lattice.cell + 2, (box.y1 * of.cell - 1) / lattice.cell + 2);
}

void clear_lattice(const Lattice& lattice) noexcept {
  const detail::RansacSearchLevel& c = lattice.cells;
  for (std::size_t i = 0; i < c.q.size(); ++i) {
    c.u[i] = c.v[i] = 0;
    c.q[i] = no_reading;
    c.w[i] = 1;
  }
  for (std::size_t i = 0; i < c.hit.size(); ++i) c.hit[i] = c.core[i] = 0;
}

SearchGate search_gate(const PlaneGate& gate, double times) noexcept {
  const double square = gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m;
  const double least = gate.fixed_m > 0 ? 0 : gate.sigmas * gate.inverse_sigma;
  const double narrow = times * static_cast<double>(mean_gate);
  constexpr float own = own_residual / mean_gate;
  return {static_cast<float>(narrow * least), static_cast<float>(narrow * square), own * own};
}

void take_row(const Lattice& lattice, const DepthCells& cells, std::int32_t row,
              const SearchGate& gate) noexcept {
  const detail::RansacSearchLevel& c = lattice.cells;
  const DepthCellRows from =
      cells.rows(lattice.level, static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice.columns));
  const std::size_t first = lattice.at(0, row);
  lattice.kernels.take_cells(
      {from.first, from.apart, static_cast<float>(cells.middle_u()), static_cast<float>(cells.middle_v())},
      lattice.columns, gate, no_reading,
      {&c.u[first], &c.v[first], &c.q[first], &c.w[first], lattice.memory.row.data()});
  // Those that fill the last group up are of the next row.
  for (std::int32_t i = lattice.columns; i < group_after(lattice.columns); ++i)
    c.q[first + static_cast<std::size_t>(i)] = no_reading;
}

void take_lattice(const Lattice& lattice, const DepthCells& cells, const SearchGate& gate) noexcept {
  for (std::int32_t row = 0; row < lattice.rows; ++row) take_row(lattice, cells, row, gate);
}

std::uint32_t count_readings(const Lattice& lattice) noexcept {
  return lattice.kernels.count_readings(&lattice.cells.q[lattice.at(0, 0)],
                                        {lattice.columns, lattice.rows, lattice.stride});
}

void mask_lattice(const Lattice& lattice, ImageView<const std::uint16_t> mask) noexcept {
  const std::int32_t side = lattice.cell, whole = mask.width / side;
  for (std::int32_t row = 0; row < lattice.rows; ++row) {
    float* q = &lattice.cells.q[lattice.at(0, row)];
    const std::int32_t v0 = row * side, rows = clamped(mask.height - v0, side);
    lattice.kernels.mask_cells(mask.row(v0), mask.stride / static_cast<std::ptrdiff_t>(sizeof(std::uint16_t)),
                               rows, side, whole, no_reading, q);
    // The last column may be cut off.
    for (std::int32_t v = v0; v < v0 + rows; ++v)
      for (std::int32_t u = whole * side; u < mask.width; ++u)
        if (mask.at(u, v) != 0) q[whole] = no_reading;
  }
}

void mask_coarser(const Lattice& fine, const Lattice& coarse) noexcept {
  for (std::int32_t row = 0; row < coarse.rows; ++row) {
    float* q = &coarse.cells.q[coarse.at(0, row)];
    const float* upper = &fine.cells.q[fine.at(0, 2 * row)];
    const float* lower = 2 * row + 1 < fine.rows ? upper + fine.stride : upper;
    for (std::int32_t column = 0; column < coarse.columns; ++column) {
      const std::int32_t left = 2 * column, right = left + 1 < fine.columns ? left + 1 : left;
      const bool all = upper[left] > 0 && upper[right] > 0 && lower[left] > 0 && lower[right] > 0;
      if (!all) q[column] = no_reading;
    }
  }
}

}  // namespace straightedge::ransac
