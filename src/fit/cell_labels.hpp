// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/plane_gate.hpp"

namespace straightedge::detail {

using CellLabels = std::array<std::span<std::uint16_t>, DepthCells::levels>;

/// Step 3 of frame_planes.hpp: every open cell of every level takes one of the planes (its index + 1) or none
/// (0); those that took none before, one of the new planes. Cells with a plane keep it.
struct CellLabeller {
  /// In place of a label: the cell may take any plane.
  static constexpr std::uint16_t open = 0x2000;
  /// Beside the label of a smallest cell that has just got it.
  static constexpr std::uint16_t fresh = 0x4000;

  const DepthCells& cells;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  const DepthKernels& kernels;
  /// Room for the planes once more, as the cells see them.
  const DepthSurfaces& surfaces;
  std::uint32_t first_new;  ///< planes from this one on are new

  void label(const CellLabels& labels) const noexcept;
};

}  // namespace straightedge::detail
