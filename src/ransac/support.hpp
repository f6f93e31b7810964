// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/lattice.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::ransac {

struct Core {
  std::uint32_t cells = 0;
  double rms_gates = 0;  ///< of the last refit to them
  CellBox bounds;        ///< of the marked cells, columns in groups; empty without any
};

/// Marks in cells.core the cells of the box that support the plane: the reading is within the gate,
/// and so are the readings of three of the eight cells round it. A plane that cuts through another surface
/// finds single cells there, not patches. Cells outside the box keep what they had.
Core mark_core(const Lattice& lattice, const InverseDepthPlane& plane, const CellBox& box,
               float gates = 1) noexcept;

/// Sums over the marked cells.
struct CoreSums {
  InverseDepthMoments moments;  ///< u and v from pixel (0, 0); the residual from the plane in place of q
  double ww = 0;                ///< squares of 1 / gate
};

/// In groups of cell_lanes cells: partial sums by place in the group for each row of cells, rows in order.
/// Rows row_step apart.
CoreSums sum_core(const Lattice& lattice, const InverseDepthPlane& plane, const CellBox& box,
                  std::int32_t row_step) noexcept;

/// Least squares on the marked cells of the box. `rms_gates` is what is left of the residuals, as a share of
/// the gate. False: too few, or on one line.
bool refit_core(const Lattice& lattice, const CellBox& box, std::int32_t row_step, double sigma,
                InverseDepthFit& fit, double& rms_gates) noexcept;

}  // namespace straightedge::ransac
