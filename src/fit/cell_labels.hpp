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

/// Step 3 of frame_planes.hpp: every cell of every level that has no plane (0) takes one (its index + 1) or
/// none.
struct CellLabeller {
  /// Beside the label of a smallest cell that has just got it.
  static constexpr std::uint16_t fresh = 0x4000;

  const DepthCells& cells;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  const DepthKernels& kernels;
  /// Room for the planes once more, as the cells see them.
  const DepthSurfaces& surfaces;
  /// A bit for each smallest cell, sixteen to the group: no plane can fit it, and it is not asked again.
  std::span<std::uint16_t> rough;

  void label(const CellLabels& labels) const noexcept;
};

}  // namespace straightedge::detail
