// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge::ransac {

/// What a cell without a reading has in place of 1/z: far outside every gate, and harmless in sums times 0.
inline constexpr float no_reading = -1e30F;

/// Cells of one row are worked on in groups of so many; see CellBox.
inline constexpr std::int32_t cell_lanes = search_lanes;

/// Empty cells left of a row; on the right there are those of the next row.
inline constexpr std::int32_t border = 16;

/// One reading of every cell of the picture. Rows are `stride` cells long and have a border of empty cells.
struct Lattice {
  Lattice(Size size, const RansacSearchOptions& options, const detail::RansacSearchMemory& arrays) noexcept
      : cell(options.cell),
        columns((size.width + cell - 1) / cell),
        rows((size.height + cell - 1) / cell),
        stride((columns + 15) / 16 * 16 + border),
        memory(arrays),
        kernels(*options.kernels) {}

  std::int32_t cell;  ///< pixels
  std::int32_t columns, rows, stride;
  const detail::RansacSearchMemory& memory;
  const PlaneSearchKernels& kernels;

  /// The readings from a place in the arrays on.
  SearchReadings readings(std::span<const float> q, std::size_t place) const noexcept {
    return {&memory.u[place], &memory.v[place], &q[place], &memory.w[place]};
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

/// So many cells more on every side, as far as the picture goes.
CellBox widened(const Lattice& lattice, const CellBox& box, std::int32_t cells) noexcept;

/// Every cell empty. The border stays so: what follows writes the cells alone.
void clear_lattice(const Lattice& lattice) noexcept;

/// Draws one reading of every cell by chance. Cells without any stay empty. Returns how many are not.
std::uint32_t draw_lattice(const Lattice& lattice, ImageView<const float> inverse_depth,
                           ImageView<const std::uint16_t> mask, const RansacSearchOptions& options) noexcept;

/// The gate of every reading becomes so many times as wide.
void widen_gates(const Lattice& lattice, double times) noexcept;

}  // namespace straightedge::ransac
