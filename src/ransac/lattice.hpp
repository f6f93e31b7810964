// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge::ransac {

/// What a cell without a reading has in place of 1/z: far outside every gate, and harmless in sums times 0.
inline constexpr float no_reading = -1e30F;

/// Means of cells stray less from their plane than pixels: so much narrower is their gate.
inline constexpr float mean_gate = 0.4F;

/// Cells of one row are worked on in groups of so many; see CellBox.
inline constexpr std::int32_t cell_lanes = search_lanes;

/// Empty cells left of a row; on the right there are those of the next row.
inline constexpr std::int32_t border = 16;

/// The picture's cells of one size, each with one reading. Rows are `stride` cells long and have a border of
/// empty cells.
struct Lattice {
  Lattice(Size size, int of_level, const RansacSearchOptions& options,
          const detail::RansacSearchMemory& all) noexcept
      : level(of_level),
        cell(DepthCells::side_of(level)),
        columns(DepthCells::size_of(size, level).width),
        rows(DepthCells::size_of(size, level).height),
        stride(static_cast<std::int32_t>(detail::RansacSearchMemory::stride_of({columns, rows}))),
        cells(all.levels[static_cast<std::size_t>(level)]),
        memory(all),
        kernels(*options.kernels) {}

  int level;          ///< of DepthCells
  std::int32_t cell;  ///< pixels
  std::int32_t columns, rows, stride;
  const detail::RansacSearchLevel& cells;
  const detail::RansacSearchMemory& memory;
  const PlaneSearchKernels& kernels;

  /// The readings from a place in the arrays on.
  SearchReadings readings(std::size_t place) const noexcept {
    return {&cells.u[place], &cells.v[place], &cells.q[place], &cells.w[place]};
  }
  /// Place in the arrays; column and row counted without the border.
  std::size_t at(std::int32_t column, std::int32_t row) const noexcept {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(stride) +
           static_cast<std::size_t>(column + border);
  }
};

inline SearchPlane in_floats(const InverseDepthPlane& p) noexcept {
  return {static_cast<float>(p.a), static_cast<float>(p.b), static_cast<float>(p.c)};
}

/// Cells [x0, x1) x [y0, y1). x0 is a multiple of cell_lanes, and so is x1 unless it is the last column: then
/// the border fills the last group up.
struct CellBox {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

inline CellBox whole(const Lattice& lattice) noexcept {
  return {0, 0, lattice.columns, lattice.rows};
}

/// The square of 2 half + 1 cells round a cell, as far as it is in the picture; x0 and x1 as above.
CellBox box_round(const Lattice& lattice, std::int32_t column, std::int32_t row, std::int32_t half) noexcept;

/// The cells that a box of another lattice's touches, and those around them.
CellBox box_over(const Lattice& lattice, const Lattice& of, const CellBox& box) noexcept;

/// Every cell empty. The border stays so: what follows writes the cells alone.
void clear_lattice(const Lattice& lattice) noexcept;

/// The gate of means of cells; that of pixels is so many times as wide as the options say.
SearchGate search_gate(const PlaneGate& gate, double times) noexcept;

/// Takes a row of the cells of a level. Those that are no reading, or curved, or of two surfaces, stay empty.
/// memory.row gets the squares of their own residuals.
void take_row(const Lattice& lattice, const DepthCells& cells, std::int32_t row,
              const SearchGate& gate) noexcept;

/// Takes all of them.
void take_lattice(const Lattice& lattice, const DepthCells& cells, const SearchGate& gate) noexcept;

/// How many cells are readings.
std::uint32_t count_readings(const Lattice& lattice) noexcept;

/// Cells with a masked pixel become empty.
void mask_lattice(const Lattice& lattice, ImageView<const std::uint16_t> mask) noexcept;

/// Cells of `coarse` become empty that have an empty one among those of `fine`.
void mask_coarser(const Lattice& fine, const Lattice& coarse) noexcept;

}  // namespace straightedge::ransac
